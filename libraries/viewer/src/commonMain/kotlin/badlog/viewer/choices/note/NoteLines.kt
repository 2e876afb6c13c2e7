package badlog.viewer.choices.note

import badlog.core.json.JsonReader
import badlog.core.json.quotedJson
import badlog.signals.json.JsonFields
import badlog.signals.json.UnreadableJsonException
import badlog.signals.json.jsonObject
import badlog.viewer.choices.AppendedLines

/**
 * One change of the notes of a log: one line of a file that is only ever appended to. To change a note is to remove it and write another.
 *
 * @property id identifies it among all laptops.
 * @property time when it was made, in UTC: `2026-03-07T14:05:12.345Z`; such times are in order as texts.
 * @property author who made it.
 * @property note the note that was written, or removed.
 * @property isRemoved whether it was removed.
 */
data class NoteChange(val id: String, val time: String, val author: String, val note: Note, val isRemoved: Boolean)

/** Returns the change as a line of JSON without its line break. Keys may be added, never removed. */
fun NoteChange.toLine(): String = jsonObject(
    "id" to quotedJson(id),
    "time" to quotedJson(time),
    "by" to quotedJson(author),
    "do" to quotedJson(if (isRemoved) REMOVE else WRITE),
    "x" to note.x.toString(),
    "text" to quotedJson(note.text),
)

/** Returns the content of [text], a file of notes, see [toLine]. */
fun noteChangesOf(text: String): AppendedLines<NoteChange> = AppendedLines.of(text, ::changeOf)

/**
 * Returns the notes that [changes] make of those at the [beginning], in the order of x: the same in whatever order they are, and however often.
 */
fun notesOf(beginning: List<Note>, changes: Collection<NoteChange>): List<Note> {
    val notes = beginning.mapTo(LinkedHashSet()) { it.atNumber() }
    val ordered = changes.map { it to it.toLine() }.sortedWith(compareBy({ it.first.time }, { it.first.id }, { it.second }))
    for (change in ordered.map { it.first }.distinctBy { it.id }) {
        if (change.isRemoved) notes -= change.note else notes += change.note
    }
    return notes.sortedWith(compareBy({ it.x }, { it.text })).take(Note.MAX_NOTES)
}

private fun changeOf(line: String): NoteChange? = try {
    val fields = JsonFields(JsonReader.readObject(line))
    val time = fields.string("time")
    val x = fields.find("x")?.takeIf { it.text == null }?.json?.toDoubleOrNull()?.takeIf { it.isFinite() }
    val text = fields.string("text").takeIf { it.isNotBlank() && it.length <= Note.MAX_TEXT }
    val deed = fields.string("do")
    if (!TIME.matches(time) || x == null || text == null || deed !in setOf(WRITE, REMOVE)) throw UnreadableJsonException()
    NoteChange(fields.string("id"), time, fields.string("by"), Note(x, text).atNumber(), deed == REMOVE)
} catch (_: UnreadableJsonException) {
    null
}

/** Minus zero is another number than zero only for computers. */
private fun Note.atNumber() = Note(x + 0.0, text)

private const val WRITE = "write"
private const val REMOVE = "remove"
private val TIME = Regex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}\\.[0-9]{3}Z")
