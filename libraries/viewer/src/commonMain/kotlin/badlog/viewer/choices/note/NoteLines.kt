package badlog.viewer.choices.note

import badlog.core.json.JsonReader
import badlog.core.json.quotedJson
import badlog.signals.json.JsonFields
import badlog.signals.json.UnreadableJsonException
import badlog.signals.json.jsonObject
import badlog.viewer.choices.AppendedLines

/**
 * One change of the notes of a log: one line of a file that is only ever appended to.
 *
 * @property id identifies the change among all laptops.
 * @property time the time of the change, in UTC: `2026-03-07T14:05:12.345Z`; sorted as texts, such times are in order.
 * @property author the person who made the change.
 * @property note the note that was written, or removed.
 * @property isRemoved whether the note was removed.
 * @property origin distinguishes the note from others at its moment, even if its text has changed; null if it began with this text.
 */
data class NoteChange(
    val id: String,
    val time: String,
    val author: String,
    val note: Note,
    val isRemoved: Boolean,
    val origin: String? = null,
)

/** Returns the change as a line of JSON without its line break. Keys may be added, never removed. */
fun NoteChange.toLine(): String = jsonObject(
    "id" to quotedJson(id),
    "time" to quotedJson(time),
    "by" to quotedJson(author),
    "do" to quotedJson(if (isRemoved) REMOVE else WRITE),
    "x" to note.x.toString(),
    "text" to quotedJson(note.text),
    "of" to origin?.let(::quotedJson),
)

/** Returns these changes as lines, each with its line break; [toLine] describes them. */
fun List<NoteChange>.toLines(): String = joinToString("") { it.toLine() + "\n" }

/** Returns the content of [text], a file of notes; [toLine] describes its lines. */
fun noteChangesOf(text: String): AppendedLines<NoteChange> = AppendedLines.of(text, ::changeOf)

private fun changeOf(line: String): NoteChange? = try {
    val fields = JsonFields(JsonReader.readObject(line))
    val time = fields.string("time")
    val x = fields.find("x")?.takeIf { it.text == null }?.json?.toDoubleOrNull()?.takeIf { it.isFinite() }
    val text = fields.string("text").takeIf { it.isNotBlank() && it.length <= Note.MAX_TEXT }
    val deed = fields.string("do")
    if (!TIME.matches(time) || x == null || text == null || deed !in setOf(WRITE, REMOVE)) throw UnreadableJsonException()
    NoteChange(fields.string("id"), time, fields.string("by"), Note(x, text).atNumber(), deed == REMOVE, fields.optional("of"))
} catch (_: UnreadableJsonException) {
    null
}

/** Returns this note with 0 for minus zero: both are the same moment. */
internal fun Note.atNumber() = Note(x + 0.0, text)

private const val WRITE = "write"
private const val REMOVE = "remove"
private val TIME = Regex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}\\.[0-9]{3}Z")
