package badlog.viewer.choices.note

import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.core.json.quotedJson
import badlog.signals.json.JsonFields
import badlog.signals.json.UnreadableJsonException
import badlog.signals.json.jsonObject
import badlog.viewer.choices.AppendedLines

/**
 * The last change of each note of a log, by any author. Neither the order of the changes nor repetitions matter. Of two changes of one
 * note the later one counts, also if it removes the note. Immutable.
 *
 * The moment of a note, which never changes, and its [origin][NoteChange.origin] identify it.
 */
class NoteHistory private constructor(private val last: Map<NoteName, NoteChange>, private val named: Map<Note, NoteName>) {
    /** Whether there has never been a note. */
    val isEmpty: Boolean get() = last.isEmpty()

    /** The notes, in the order of x; notes of one moment in the order of writing. */
    val notes: List<Note>
        get() = last.values.filter { !it.isRemoved }.map { it.note }.distinct().sortedBy { it.x }.take(Note.MAX_NOTES)

    /** The notes that have not changed since the beginning. Together with [changes], they make up this history. */
    val unchanged: List<Note> get() = last.values.filter { it.time.isEmpty() }.map { it.note }

    /** The last change of each note that has changed since the beginning. Removed notes have no text. */
    val changes: List<NoteChange> get() = last.values.filter { it.time.isNotEmpty() }

    /**
     * Returns the changes that turn the notes [before], which were read from this history or an earlier one, into [notes].
     *
     * @param timeAfter returns the current time. It must be later than the argument, the time of the note's last change, unless that is
     *   null.
     * @param newId returns an id that no other change has.
     */
    fun changesTo(
        notes: List<Note>,
        before: List<Note>,
        author: String,
        timeAfter: (last: String?) -> String,
        newId: () -> String,
    ): List<NoteChange> {
        fun change(name: NoteName, note: Note, isRemoved: Boolean = false) =
            NoteChange(newId(), timeAfter(last[name]?.time?.ifEmpty { null }), author, note, isRemoved, name.second)

        val gone = (before - notes.toSet()).toMutableList()
        val written = (notes - before.toSet()).flatMap { note ->
            val old = gone.find { it.x == note.x }
            if (old == null) {
                listOf(change(newNameOf(note, newId), note))
            } else {
                gone -= old
                // An older badlog identifies notes by their texts alone. A new text comes before the removal of the one that it replaces:
                // if the lines are cut off, both are there rather than neither.
                val (name, same) = namesOf(old).let { it.first() to it.drop(1) }
                listOf(change(name, note), change(name, old, isRemoved = true).copy(origin = null)) +
                    same.map { change(it, old, isRemoved = true) }
            }
        }
        return written + gone.flatMap { note -> namesOf(note).map { change(it, note, isRemoved = true) } }
    }

    private fun namesOf(note: Note): List<NoteName> =
        last.filterValues { !it.isRemoved && it.note == note }.keys.toList().ifEmpty { listOf(named[note] ?: nameOf(note)) }

    /** Returns a new name if another note, changed since, began at the same moment with the same text. */
    private fun newNameOf(note: Note, newId: () -> String): NoteName {
        val name = nameOf(note)
        val other = last[name] ?: return name
        return if (other.isRemoved || other.note == note) name else note.x to newId()
    }

    companion object {
        /** Returns the history that begins with the notes [beginning] and continues with [changes]. */
        fun of(beginning: List<Note>, changes: Collection<NoteChange>): NoteHistory {
            val last = LinkedHashMap<NoteName, NoteChange>()
            val named = HashMap<Note, NoteName>()

            fun take(change: NoteChange) {
                val name = change.name
                // Such a removal means only this text; the note may have another one since.
                if (change.isRemoved && change.origin == null && last[name]?.note != change.note) return
                if (!change.isRemoved) named[change.note] = name
                val note = if (change.isRemoved) Note(name.first, REMOVED) else change.note
                last[name] = change.copy(note = note, origin = name.second)
            }
            for (note in beginning) take(NoteChange("", "", "", note.atNumber(), isRemoved = false))
            val ordered = changes.map { it to it.toLine() }.sortedWith(compareBy({ it.first.time }, { it.first.id }, { it.second }))
            for ((change, _) in ordered) take(change)
            return NoteHistory(last, named)
        }

        /** Replaces the text of a removed note, so that it can no longer be read. */
        private const val REMOVED = "removed"
    }
}

/** The identity of a note: its moment and its origin. */
private typealias NoteName = Pair<Double, String>

/** Returns the name of a note that began as [note]. It has a hash instead of the text, because removed texts should be unreadable. */
private fun nameOf(note: Note): NoteName = note.x to note.text.hashCode().toString()

private val NoteChange.name: NoteName get() = origin?.let { note.x to it } ?: nameOf(note)

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
