package badlog.viewer.panel.folder

import badlog.viewer.panel.Button
import badlog.viewer.panel.Card
import badlog.viewer.panel.Check
import badlog.viewer.panel.Fold
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.Row
import badlog.viewer.panel.Rows
import badlog.viewer.panel.Tone
import badlog.viewer.panel.newItemForm
import badlog.viewer.panel.nextMatchForm
import badlog.viewer.panel.offersFor
import badlog.viewer.state.Action
import badlog.viewer.state.FolderAction
import badlog.viewer.state.FolderRequest
import badlog.viewer.state.Request
import badlog.viewer.text.word
import badlog.viewer.todo.CHECKLIST_FILE
import badlog.viewer.todo.CheckedLine
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoItem
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.checklistTitle
import badlog.viewer.todo.lines

/**
 * The team's list with its checklist.
 *
 * @property hasFolder whether a folder is open, which stores the list.
 * @property hasOwnLines whether the team has added lines of its own to the checklist.
 * @property author the person at this computer.
 */
data class ListedTodo(
    val list: TodoList,
    val checks: List<CheckedLine>,
    val hasFolder: Boolean,
    val hasOwnLines: Boolean,
    val author: String,
)

/**
 * Returns the team's list: open items, the checklist before the next match, and done items, folded.
 *
 * @param unfolded the parts of panels that a person has unfolded.
 * @param pathOf returns the path of the log with a file name; null if it is not in the folder.
 */
fun todoPanel(todo: ListedTodo, unfolded: Map<String, Boolean>, pathOf: (name: String) -> String?): List<Part> {
    val list = todo.list
    val tools = listOf(
        Button("New item…", ask(FolderRequest.Fill(newItemForm())), PartIcon.ADD, "New item", todo.hasFolder),
        Button("Copy as Markdown", ask(FolderRequest.CopyTodo), hint = "Copy the list as Markdown", isEnabled = todo.hasFolder),
        Button("Save as page…", ask(FolderRequest.SaveTodo), hint = "Save the list as a page", isEnabled = todo.hasFolder),
    )
    fun rows(key: String, name: String, items: List<TodoItem>) =
        Rows(key, name, items.map { rowOf(it, todo, it.found?.log?.name?.let(pathOf)) })
    val empty = if (todo.hasFolder) NOTHING_OPEN else "Open a folder of logs; its list is kept beside them."
    val isOpen = unfolded[DONE] == true
    return listOfNotNull(
        Heading(TITLE, "", tools),
        if (list.open.isEmpty()) Paragraph("empty", empty, Tone.MUTED) else rows("open", TITLE, list.open),
    ) + (if (todo.hasFolder) checklist(todo) else emptyList()) + listOfNotNull(
        Fold(DONE, "Done: ${list.done.size}", isOpen, if (isOpen) listOf(rows("done", "Done", list.done)) else emptyList())
            .takeIf { list.done.isNotEmpty() },
    )
}

/** Returns the open items and the progress of the checklist for a look between two matches; null if there is nothing to do. */
fun pitTodo(todo: ListedTodo): Card? {
    val open = todo.list.open
    if (!todo.hasFolder || (open.isEmpty() && todo.checks.isEmpty())) return null
    val items = open.take(MAX_IN_PIT).map { item ->
        "• ${item.title}" + (if (item.isAgain) ", again" else "") + if (item.person.isEmpty()) "" else " (${item.person})"
    }
    val lines = items + listOfNotNull(
        if (open.size > MAX_IN_PIT) "and ${open.size - MAX_IN_PIT} more" else null,
        if (todo.checks.isEmpty()) null else "Checklist: ${todo.checks.count { it.done != null }} of ${todo.checks.size}",
    )
    val title = if (open.isEmpty()) "Nothing is open" else TITLE
    return Card("todo", title, lines = lines, open = ask(FolderRequest.Todo), hint = "Show the to-do list")
}

private fun checklist(todo: ListedTodo): List<Part> {
    val title = checklistTitle(todo.list.next)
    val next = Button("Next match…", ask(FolderRequest.Fill(todo.list.nextMatchForm())), hint = "Set the next match")
    return listOfNotNull(
        Paragraph("checklist", title, Tone.TITLE, next),
        Rows("checks", title, todo.checks.map(::rowOf)),
        if (todo.hasOwnLines) null else Paragraph("own", OWN_LINES, Tone.MUTED),
    )
}

private fun rowOf(item: TodoItem, todo: ListedTodo, path: String?): Row {
    val offers = todo.list.offersFor(item.task, todo.author)
    val mark = offers.first()
    val person = if (item.person.isEmpty()) null else Paragraph("person", "To do: ${item.person}")
    val severity = item.found?.severity?.takeIf { item.isOpen }
    // Screen readers read only the name of a row.
    val name = (listOfNotNull(severity?.word, item.title, person?.text) + item.lines).joinToString(". ")
    return Row(
        "item ${item.task}",
        severity,
        if (path == null) name else "$name. Show what was found in ${item.found?.log?.title}",
        item.title,
        emptyList(),
        open = path?.let { FolderAction.Open(it, showsFinding = true) },
        check = Check("${mark.label.trimEnd('…')}: ${item.title}", !item.isOpen, ask(mark.request)),
        tools = offers.drop(1).map { Button(it.label, ask(it.request), it.icon, "${it.label}: ${item.title}") },
        below = listOfNotNull(person) + item.lines.mapIndexed { i, line ->
            Paragraph("line $i", line, if (i == 0 && item.isAgain) Tone.ALERT else Tone.MUTED)
        },
    )
}

private fun rowOf(line: CheckedLine): Row {
    val done = line.done
    val toggle = ask(FolderRequest.WriteTodo(line.check, if (done == null) TodoDeed.Done() else TodoDeed.Open))
    return Row(
        "check ${line.check.text}",
        severity = null,
        line.check.text,
        line.check.text,
        emptyList(),
        open = toggle,
        check = Check("Check: ${line.check.text}", done != null, toggle),
        below = listOfNotNull(done?.let { Paragraph("by", it.by, Tone.MUTED) }),
    )
}

private fun ask(request: Request) = Action.Ask(request)

private const val TITLE = "To do"
private const val DONE = "todo-done"
private const val NOTHING_OPEN = "Nothing is open. Errors of the last matches appear here; put others here from the findings of a log."
private const val OWN_LINES = "To add lines of your own, write them into $CHECKLIST_FILE in the folder of the logs."

/** The number of items that are read at a glance. */
private const val MAX_IN_PIT = 4
