package badlog.viewer.panel

import badlog.rules.Finding
import badlog.viewer.choices.note.Note
import badlog.viewer.state.Action
import badlog.viewer.state.FolderRequest
import badlog.viewer.state.Form
import badlog.viewer.state.FormField
import badlog.viewer.state.Request
import badlog.viewer.todo.NextMatch
import badlog.viewer.todo.NoteTask
import badlog.viewer.todo.OwnTask
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoItem
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.TodoSubject
import badlog.viewer.todo.TodoTask
import badlog.viewer.todo.UNNAMED_MATCH
import badlog.viewer.todo.againText
import badlog.viewer.todo.matchText
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

/** The findings and notes of the log with the file name [log] in the team's [list], which [author] changes. */
class ListedTasks(private val list: TodoList, private val log: String, private val author: String) : TodoOfLog {
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
        val title = list.itemOrNew(task).title
        return list.offersFor(task, author).map { Button(it.label, Action.Ask(it.request), it.icon, "${it.label}: $title") }
    }
}

/** A possible action on an item of the team's list. */
class TodoOffer(val label: String, val icon: PartIcon, val request: Request)

/**
 * Returns the possible actions of [author] on [task], which need not be on the list yet; the first marks it as done or not done.
 */
fun TodoList.offersFor(task: TodoTask, author: String): List<TodoOffer> {
    val item = itemOrNew(task)
    val assign = TodoOffer("Assign…", PartIcon.PERSON, FolderRequest.Fill(assignForm(item)))
    if (!item.isOpen) return listOf(TodoOffer("Not done", PartIcon.UNDONE, FolderRequest.WriteTodo(task, TodoDeed.Open)), assign)
    return listOf(
        TodoOffer("Mark as done…", PartIcon.DONE, FolderRequest.Fill(doneForm(item, author))),
        assign,
        if (item(task) == null) {
            TodoOffer("Put on the list", PartIcon.ADD, FolderRequest.WriteTodo(task, TodoDeed.Open))
        } else {
            TodoOffer("Take off the list", PartIcon.REMOVE, FolderRequest.WriteTodo(task, TodoDeed.Remove))
        },
    )
}

/** Asks how [item] was done; [author] is the person at this computer. */
internal fun TodoList.doneForm(item: TodoItem, author: String): Form {
    val fields = listOf(FormField("What was done"), FormField("Before which match", next), FormField("By whom", author))
    return Form("Mark as done: ${item.title}", fields, "Mark as done") { (what, before, by) ->
        listOf(write(item.task, TodoDeed.Done(what, matchText(before, lastMatch).ifEmpty { null }), by.ifEmpty { null }))
    }
}

/** Asks who takes on [item]. */
internal fun assignForm(item: TodoItem): Form = Form("Assign: ${item.title}", listOf(FormField(WHO, item.person)), "Assign") { (person) ->
    listOf(write(item.task, TodoDeed.Assign(person)))
}

/** Asks for a new item. */
internal fun newItemForm(): Form =
    Form("New item", listOf(FormField("What is to be done", isNeeded = true), FormField(WHO)), "Add") { (text, person) ->
        val task = OwnTask(text)
        listOf(write(task, TodoDeed.Open)) + if (person.isEmpty()) emptyList() else listOf(write(task, TodoDeed.Assign(person)))
    }

/** Asks which match is the next one. */
internal fun TodoList.nextMatchForm(): Form {
    val known = if (next.startsWith("the ") || next == UNNAMED_MATCH) "" else next
    val field = FormField("Next match, such as Qualification 61 or q61", known, isNeeded = true)
    return Form("Set the next match", listOf(field), "Set") { (match) ->
        listOf(write(NextMatch(matchText(match, lastMatch)), TodoDeed.Open))
    }
}

private fun write(subject: TodoSubject, deed: TodoDeed, by: String? = null) = Action.Ask(FolderRequest.WriteTodo(subject, deed, by))

private const val WHO = "Who takes it on; nobody if empty"
