package badlog.viewer.todo

import badlog.core.json.JsonReader
import badlog.core.json.quotedJson
import badlog.signals.json.JsonFields
import badlog.signals.json.UnreadableJsonException
import badlog.signals.json.jsonObject
import badlog.viewer.choices.AppendedLines

/** Returns the content of [text], a to-do file; [toLine] describes its lines. */
fun todoChangesOf(text: String): AppendedLines<TodoChange> = AppendedLines.of(text, ::changeOf)

/** Returns the change as a line of JSON without its line break. Keys may be added, never removed; `docs/todo.md` lists them. */
fun TodoChange.toLine(): String {
    val (about, deed) = subject.members() to deed.members()
    val members = listOf("id" to id, "time" to time, "by" to author) + deed + about + listOf("event" to event)
    val texts = members.map { (key, text) -> key to text?.let(::quotedJson) }
    val x = (subject as? NoteTask)?.x
    return jsonObject(*texts.toTypedArray(), "x" to x?.toString(), "seen" to seen?.toString())
}

private fun TodoSubject.members(): List<Pair<String, String?>> = when (this) {
    is FaultTask -> listOf("rule" to rule, "topic" to topic)
    is NoteTask -> listOf("note" to text, "log" to log)
    is OwnTask -> listOf("task" to text)
    is Check -> listOf("check" to text, "match" to match)
    is NextMatch -> listOf("next" to match)
}

private fun TodoDeed.members(): List<Pair<String, String?>> = when (this) {
    TodoDeed.Open -> listOf("do" to "open")
    TodoDeed.Remove -> listOf("do" to "remove")
    is TodoDeed.Assign -> listOf("do" to "assign", "to" to person)
    is TodoDeed.Done -> listOf("do" to "done", "what" to what, "before" to before)
}

/** Returns the change in [line]; null if the line is not a change. */
private fun changeOf(line: String): TodoChange? = try {
    val fields = JsonFields(JsonReader.readObject(line))
    TodoChange(
        id = fields.required("id"),
        time = fields.required("time").also { if (!TIME.matches(it)) throw UnreadableJsonException() },
        author = fields.required("by"),
        subject = subjectOf(fields),
        deed = deedOf(fields),
        seen = fields.find("seen")?.let { it.json.toLongOrNull() ?: throw UnreadableJsonException() },
        event = fields.text("event"),
    )
} catch (_: UnreadableJsonException) {
    null
}

private fun subjectOf(fields: JsonFields): TodoSubject {
    val rule = fields.text("rule")
    val note = fields.text("note")
    val task = fields.text("task")
    val check = fields.text("check")
    return when {
        rule != null -> FaultTask(rule, fields.text("topic"))
        note != null -> NoteTask(fields.required("log"), xOf(fields), note)
        task != null -> OwnTask(task)
        check != null -> Check(check, fields.required("match"))
        else -> NextMatch(fields.required("next"))
    }
}

// Zero and minus zero are the same moment.
private fun xOf(fields: JsonFields): Double =
    fields.find("x")?.takeIf { it.text == null }?.json?.toDoubleOrNull()?.takeIf { it.isFinite() }?.let { it + 0.0 }
        ?: throw UnreadableJsonException()

private fun deedOf(fields: JsonFields): TodoDeed = when (fields.required("do")) {
    "open" -> TodoDeed.Open
    "remove" -> TodoDeed.Remove
    "assign" -> TodoDeed.Assign(fields.find("to")?.text?.take(TodoChange.MAX_TEXT) ?: throw UnreadableJsonException())
    "done" -> TodoDeed.Done(fields.find("what")?.text.orEmpty().take(TodoChange.MAX_TEXT), fields.text("before"))
    else -> throw UnreadableJsonException()
}

/** Returns the text of [key]; null if it is absent or blank. */
private fun JsonFields.text(key: String): String? = optional(key)?.takeIf { it.isNotBlank() }?.take(TodoChange.MAX_TEXT)

private fun JsonFields.required(key: String): String = text(key) ?: throw UnreadableJsonException()

private val TIME = Regex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}\\.[0-9]{3}Z")
