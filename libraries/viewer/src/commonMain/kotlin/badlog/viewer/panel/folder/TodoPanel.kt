package badlog.viewer.panel.folder

import badlog.viewer.catalog.ListedLog
import badlog.viewer.panel.Button
import badlog.viewer.panel.Card
import badlog.viewer.panel.Cards
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
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.folder.PitLogs
import badlog.viewer.shown.folder.pitFacts
import badlog.viewer.shown.folder.verdictText
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
import badlog.viewer.todo.toMarkdown

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
    val copy = Request.Copy { list.toMarkdown(todo.checks.map { it.check.text }) }
    val tools = listOf(
        Button("New item…", ask(FolderRequest.Fill(newItemForm())), PartIcon.ADD, "New item", todo.hasFolder),
        Button("Copy as Markdown", ask(copy), hint = "Copy the list as Markdown", isEnabled = todo.hasFolder),
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

/**
 * Returns the last log, batteries, the team's list and earlier logs, for a look between two matches.
 *
 * @param logs the logs; null if there are none.
 * @param emptiness the reason for that, as a sentence.
 * @param openBatteries shows the batteries; null if that is impossible.
 * @param todo the team's list, see [pitTodo]; null if there is none.
 * @param willRead returns whether a log is read without being opened.
 */
fun <E : ListedLog> pitPanel(
    logs: PitLogs<E>?,
    emptiness: String,
    advice: BatteryAdvice,
    openBatteries: Action? = null,
    todo: Card? = null,
    willRead: (E) -> Boolean = { true },
): List<Part> {
    val heading = Heading("Pit view", "")
    if (logs == null) return listOf(heading, Paragraph("empty", emptiness, Tone.TITLE))
    val batteries = advice.inPit.mapIndexed { i, each ->
        val severity = each.severity.takeIf { each !== advice.next }
        Card("battery $i", each.pitText, severity = severity, open = openBatteries, hint = "Show the batteries")
    }
    return listOf(
        heading,
        Paragraph("pit-title", logs.last.title, Tone.TITLE),
        Paragraph("pit-facts", pitFacts(logs.last), Tone.MUTED),
        lastLog(logs.last, willRead(logs.last)),
    ) + batteries + listOfNotNull(
        todo,
        Cards("pit-before", logs.before.map { earlierLog(it, willRead(it)) }).takeIf { it.cards.isNotEmpty() },
    )
}

private fun lastLog(log: ListedLog, isRead: Boolean): Card {
    val verdict = log.found?.verdict
    val next = verdict?.next.orEmpty()
    val unread = if (isUnread(log, isRead)) listOf("Open it to see what is in it.") else emptyList()
    val lines = unread + verdict?.sentences.orEmpty() + listOf("Next: $next").filter { next.isNotEmpty() }
    return cardOf(log, "", isRead, lines, isLarge = true)
}

private fun earlierLog(log: ListedLog, isRead: Boolean) = cardOf(log, log.title, isRead, emptyList(), isLarge = false)

private fun cardOf(log: ListedLog, title: String, isRead: Boolean, lines: List<String>, isLarge: Boolean) = Card(
    log.path,
    title,
    if (isUnread(log, isRead)) "Not read yet" else verdictText(log.found),
    lines,
    log.found?.verdict?.severity,
    isLarge,
    FolderAction.Open(log.path, showsFinding = true),
    "Show what was found in ${log.title}",
)

private fun isUnread(log: ListedLog, isRead: Boolean) = log.found == null && !isRead
