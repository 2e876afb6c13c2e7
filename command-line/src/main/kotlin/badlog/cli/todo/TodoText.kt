package badlog.cli.todo

import badlog.cli.text.counted
import badlog.cli.text.jsonOf
import badlog.cli.text.wrapped
import badlog.viewer.todo.CheckedLine
import badlog.viewer.todo.FaultTask
import badlog.viewer.todo.NoteTask
import badlog.viewer.todo.TodoItem
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.checklistTitle
import badlog.viewer.todo.lines
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.JsonObject

/** Returns [list] and the [checklist] before the next match, in lines of [width]. */
internal fun todoText(list: TodoList, checklist: List<String>, width: Int): String = buildString {
    append(if (list.open.isEmpty()) "Nothing is open." else "${counted(list.open.size.toLong(), "item")} to do:")
    val digits = "${list.numbered.size}".length
    val numbers = list.numbered.withIndex().associate { (place, item) -> item.task to "${place + 1}".padStart(digits) }
    for (item in list.open) appendItem(numbers.getValue(item.task), item, width)
    val lines = list.checklist(checklist)
    if (lines.isNotEmpty()) append("\n\n${checklistTitle(list.next)}:")
    for (line in lines) {
        append('\n').append(wrapped(box(line.done != null), line.check.text + line.done?.let { " (${it.by})" }.orEmpty(), width = width))
    }
    if (list.done.isNotEmpty()) append("\n\nDone:")
    for (item in list.done) appendItem(numbers.getValue(item.task), item, width)
}

private fun StringBuilder.appendItem(number: String, item: TodoItem, width: Int) {
    val person = if (item.person.isEmpty()) "" else " (${item.person})"
    val begin = "$number ${box(!item.isOpen)}"
    append('\n').append(wrapped(begin, oneLine(item.title) + person, width = width))
    for (line in item.lines) append('\n').append(wrapped(" ".repeat(begin.length), oneLine(line), width = width))
}

private fun oneLine(text: String) = text.replace(Regex("\\s+"), " ")

private fun box(isTicked: Boolean) = if (isTicked) "[x] " else "[ ] "

/** Returns an object for each item of [list], and for each line of the [checklist] before the next match. */
internal fun todoJson(list: TodoList, checklist: List<String>): List<JsonObject> =
    list.numbered.mapIndexed { place, item -> jsonOf(ItemJson(place + 1, item)) } + list.checklist(checklist).map { jsonOf(CheckJson(it)) }

@Serializable
private class ItemJson(
    private val command: String,
    private val status: String,
    private val number: Int,
    private val item: String,
    private val topic: String?,
    private val severity: String?,
    private val person: String?,
    private val what: String?,
    private val by: String?,
    private val before: String?,
    private val log: String?,
    private val text: String?,
) {
    constructor(number: Int, item: TodoItem) : this(
        command = "todo",
        status = if (item.isAgain) {
            "again"
        } else if (item.isOpen) {
            "open"
        } else {
            "done"
        },
        number = number,
        item = item.title,
        topic = (item.task as? FaultTask)?.topic,
        severity = item.found?.severity?.name?.lowercase(),
        person = item.person.ifEmpty { null },
        what = item.done?.what,
        by = item.done?.by,
        before = item.done?.before,
        log = item.found?.log?.name ?: (item.task as? NoteTask)?.log,
        text = item.found?.fault?.text,
    )
}

/** A line of the checklist, for programs. */
@Serializable
private class CheckJson(
    private val command: String,
    private val status: String,
    private val check: String,
    private val match: String,
    private val by: String?,
) {
    constructor(line: CheckedLine) :
        this("todo", if (line.done == null) "open" else "done", line.check.text, line.check.match, line.done?.by)
}
