package badlog.viewer.panel.finding

import badlog.rules.Finding
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
import badlog.viewer.todo.againText
import badlog.viewer.todo.taskOf
import badlog.viewer.todo.text

/** The team's list in the panel of findings. Only a shell with a list has [ListedFindings]: the page contains no code of them. */
interface TodoOfFindings {
    /** Returns the state of [finding] in the list, as sentences; empty for a new finding. */
    fun linesOf(finding: Finding): List<Part>

    /** Returns the buttons for [finding], with which a team changes its list. */
    fun buttonsOf(finding: Finding): List<Button>
}

/** The findings in the team's [list]. */
class ListedFindings(private val list: TodoList) : TodoOfFindings {
    override fun linesOf(finding: Finding): List<Part> {
        val item = list.item(taskOf(finding)) ?: return emptyList()
        val done = item.done?.takeIf { !item.isOpen || item.isAgain }
        return listOfNotNull(
            if (item.isAgain) Paragraph("again", item.againText, Tone.ALERT) else null,
            done?.let { Paragraph("done", it.text, Tone.MUTED) },
            if (item.isOpen && item.person.isNotEmpty()) Paragraph("person", "To do: ${item.person}", Tone.MUTED) else null,
        )
    }

    override fun buttonsOf(finding: Finding): List<Button> {
        val task = taskOf(finding)
        val item = list.itemOrNew(task)
        fun button(label: String, icon: PartIcon, request: Request) = Button(label, Action.Ask(request), icon, "$label: ${item.title}")
        val assign = button("Assign…", PartIcon.PERSON, TodoRequest.AskPerson(item))
        return when {
            !item.isOpen -> listOf(button("Not done", PartIcon.UNDONE, TodoRequest.Write(task, TodoDeed.Open)), assign)

            else -> listOf(
                button("Mark as done…", PartIcon.DONE, TodoRequest.AskDone(item)),
                assign,
                if (list.item(task) == null) {
                    button("Put on the list", PartIcon.ADD, TodoRequest.Write(task, TodoDeed.Open))
                } else {
                    button("Take off the list", PartIcon.REMOVE, TodoRequest.Write(task, TodoDeed.Remove))
                },
            )
        }
    }
}
