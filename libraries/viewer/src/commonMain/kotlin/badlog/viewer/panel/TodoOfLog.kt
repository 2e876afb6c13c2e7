package badlog.viewer.panel

import badlog.rules.Finding
import badlog.viewer.choices.note.Note
import badlog.viewer.state.Action
import badlog.viewer.state.Request
import badlog.viewer.state.TodoRequest
import badlog.viewer.todo.NoteTask
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.TodoTask
import badlog.viewer.todo.againText
import badlog.viewer.todo.taskOf
import badlog.viewer.todo.text

/** The team's list in the panels of a log. Only a shell with a list uses [ListedTasks]: the page does not contain its code. */
interface TodoOfLog {
    /** Returns the state of [finding] in the list, as sentences; empty for a new finding. */
    fun linesOf(finding: Finding): List<Part>

    /** Returns the buttons for [finding], with which a team changes its list. */
    fun buttonsOf(finding: Finding): List<Button>

    /** Returns the state of [note] in the list, and the buttons for it. */
    fun partsOf(note: Note): List<Part>
}

/** The findings and notes of the log with the file name [log] in the team's [list]. */
class ListedTasks(private val list: TodoList, private val log: String) : TodoOfLog {
    override fun linesOf(finding: Finding): List<Part> = linesOf(taskOf(finding))

    override fun buttonsOf(finding: Finding): List<Button> = buttonsOf(taskOf(finding))

    override fun partsOf(note: Note): List<Part> {
        // A zero has no sign on the list.
        val task = NoteTask(log, note.x + 0.0, note.text)
        return linesOf(task) + Buttons("todo", buttonsOf(task))
    }

    private fun linesOf(task: TodoTask): List<Part> {
        val item = list.item(task) ?: return emptyList()
        val done = item.done?.takeIf { !item.isOpen || item.isAgain }
        return listOfNotNull(
            if (item.isAgain) Paragraph("again", item.againText, Tone.ALERT) else null,
            done?.let { Paragraph("done", it.text, Tone.MUTED) },
            if (item.isOpen && item.person.isNotEmpty()) Paragraph("person", "To do: ${item.person}", Tone.MUTED) else null,
        )
    }

    private fun buttonsOf(task: TodoTask): List<Button> {
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
