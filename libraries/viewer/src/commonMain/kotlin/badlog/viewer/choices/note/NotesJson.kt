package badlog.viewer.choices.note

import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.core.json.quotedJson

/** The exception for a text that is not a log's notes, or for notes that cannot be read; the message is a sentence with the reason. */
class NotesException(message: String) : Exception(message)

/** Returns these notes in the order of x, as JSON: `{"version":1,"notes":[{"x":93.7,"text":"…"}]}`. Keys may be added, never removed. */
fun List<Note>.toJson(): String = sortedBy { it.x }.joinToString(",\n", "{\"version\":$VERSION,\"notes\":[\n", "\n]}\n") {
    "{\"x\":${it.x},\"text\":${quotedJson(it.text)}}"
}

/**
 * Returns the notes in [text], in the order of x; [toJson] describes it. Unknown keys are ignored.
 *
 * @throws NotesException if the text has no notes, or too many, or if one is damaged.
 */
fun notesOfJson(text: String): List<Note> {
    val members = JsonReader.readObject(text) ?: throw NotesException("This is not a JSON object.")
    val version = members.findLast { it.key == "version" }?.value?.json?.toIntOrNull()
    if (version != null && version > VERSION) throw NotesException("The notes were saved by a newer badlog; update badlog.")
    val items = members.findLast { it.key == "notes" }?.value?.items ?: throw NotesException("“notes” is not a list.")
    if (items.size > Note.MAX_NOTES) throw NotesException("There are ${items.size} notes; a log has at most ${Note.MAX_NOTES}.")
    return items.mapIndexed { i, item -> noteOf(i + 1, item) }.sortedBy { it.x }
}

private fun noteOf(number: Int, json: JsonValue): Note {
    fun member(key: String) = json.members?.findLast { it.key == key }?.value
    val x = member("x")?.takeIf { it.text == null }?.json?.toDoubleOrNull()?.takeIf { it.isFinite() }
        ?: throw NotesException("“x” of note $number is not a number.")
    val text = member("text")?.text?.takeIf { it.isNotBlank() } ?: throw NotesException("“text” of note $number is missing.")
    if (text.length > Note.MAX_TEXT) {
        throw NotesException("“text” of note $number has ${text.length} characters; at most ${Note.MAX_TEXT} are allowed.")
    }
    return Note(x, text)
}

private const val VERSION = 1
