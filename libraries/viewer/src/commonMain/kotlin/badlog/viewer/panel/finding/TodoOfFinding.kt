package badlog.viewer.panel.finding

import badlog.viewer.panel.Button
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.Tone
import badlog.viewer.state.Action
import badlog.viewer.state.Request
import badlog.viewer.state.TodoRequest
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.TodoTask
import badlog.viewer.todo.againText
import badlog.viewer.todo.text

/** Returns lines about [task] from [todo]; empty if the list does not have the task. */
internal fun todoLines(todo: TodoList?, task: TodoTask): List<Part> {
    val item = todo?.item(task) ?: return emptyList()
    val done = item.done?.takeIf { !item.isOpen || item.isAgain }
    return listOfNotNull(
        if (item.isAgain) Paragraph("again", item.againText, Tone.ALERT) else null,
        done?.let { Paragraph("done", it.text, Tone.MUTED) },
        if (item.isOpen && item.person.isNotEmpty()) Paragraph("person", "To do: ${item.person}", Tone.MUTED) else null,
    )
}

/** Returns the buttons for a team's actions on [task]. */
internal fun todoButtons(todo: TodoList, task: TodoTask): List<Button> {
    val isListed = todo.item(task) != null
    val item = todo.itemOrNew(task)
    fun button(label: String, icon: PartIcon, request: Request) = Button(label, Action.Ask(request), icon, "$label: ${item.title}")
    val assign = button("Assign…", PartIcon.PERSON, TodoRequest.AskPerson(item))
    return if (item.isOpen) {
        listOf(
            button("Mark as done…", PartIcon.DONE, TodoRequest.AskDone(item)),
            assign,
            if (isListed) {
                button("Take off the list", PartIcon.REMOVE, TodoRequest.Write(task, TodoDeed.Remove))
            } else {
                button("Put on the list", PartIcon.ADD, TodoRequest.Write(task, TodoDeed.Open))
            },
        )
    } else {
        listOf(button("Not done", PartIcon.UNDONE, TodoRequest.Write(task, TodoDeed.Open)), assign)
    }
}
