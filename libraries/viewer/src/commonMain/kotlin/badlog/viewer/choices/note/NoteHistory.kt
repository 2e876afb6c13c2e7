package badlog.viewer.choices.note

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
