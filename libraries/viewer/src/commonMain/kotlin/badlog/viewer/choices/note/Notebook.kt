package badlog.viewer.choices.note

/**
 * The notes of a log, and the one that a person is writing. Immutable; each step returns a new one.
 *
 * @property notes the notes, in the order of x.
 * @property draft the note that is being written or changed; null if there is none.
 */
data class Notebook(val notes: List<Note> = emptyList(), val draft: NoteDraft? = null) {
    /** The reason why another note cannot be added, as a sentence; null if it can. */
    val fullness: String?
        get() = if (notes.size < Note.MAX_NOTES) null else "This log has ${Note.MAX_NOTES} notes; remove one first."

    /** Begins a note at [x]. */
    fun begun(x: Double): Notebook = copy(draft = NoteDraft(x, "", null))

    /** Begins to change [note]. */
    fun changing(note: Note): Notebook = copy(draft = NoteDraft(note.x, note.text, note))

    /** Sets the text of the draft, cut off at the maximum length of a note. */
    fun typed(text: String): Notebook = copy(draft = draft?.copy(text = text.take(Note.MAX_TEXT)))

    /** Discards the draft. */
    fun cancelled(): Notebook = copy(draft = null)

    /** Adds the draft to the notes, or replaces the note that it changes; a draft without text is discarded. */
    fun kept(): Notebook {
        val written = draft ?: return this
        if (written.text.isBlank()) return cancelled()
        return Notebook(inOrder(notes - setOfNotNull(written.replaced) + Note(written.x, written.text.trim())))
    }

    /** Removes [note]. */
    fun without(note: Note): Notebook = copy(notes = notes - note)

    /** Restores the removed [note]. */
    fun restored(note: Note): Notebook = if (note in notes) this else with(notes + note)

    /** Replaces the notes by [notes], for example because another window has changed them; the draft stays. */
    fun with(notes: List<Note>): Notebook = copy(notes = inOrder(notes))

    private fun inOrder(notes: List<Note>) = notes.sortedBy { it.x }
}

/**
 * A note that is being written.
 *
 * @property x the moment, in the unit of the log's x axis.
 * @property text the text so far; may be empty.
 * @property replaced the note that it changes; null for a new one.
 */
data class NoteDraft(val x: Double, val text: String, val replaced: Note?)

/** Returns the message after the note at the time [moment] was removed. */
fun removedText(moment: String): String = "The note at $moment was removed."

/** Returns these notes with a mark at [x]. The mark is a note with a numbered text, such as `Mark 3`, which can be changed later. */
fun Notebook.marked(x: Double): Notebook {
    val last = notes.mapNotNull { MARK.matchEntire(it.text)?.groupValues?.get(1)?.toInt() }.maxOrNull() ?: 0
    return with(notes + Note(x, "Mark ${last + 1}"))
}

/** Returns the message about a mark that was added at [place], such as `12.3 s`. */
fun markedText(place: String): String = "Marked at $place; the mark is a note, whose text you can change."

private val MARK = Regex("Mark (\\d{1,6})")

/**
 * A person's note about a moment of a log.
 *
 * @property x the moment, in the unit of the log's x axis; finite.
 * @property text the text; not blank, at most [MAX_TEXT] characters.
 * @throws IllegalArgumentException if [x] or [text] is invalid.
 */
data class Note(val x: Double, val text: String) {
    init {
        require(x.isFinite()) { "A note needs a place on x, not $x." }
        require(text.isNotBlank() && text.length <= MAX_TEXT) { "A note has 1 to $MAX_TEXT characters, not ${text.length}." }
    }

    companion object {
        /** The maximum number of characters in a note. */
        const val MAX_TEXT: Int = 2000

        /** The maximum number of notes for a log. */
        const val MAX_NOTES: Int = 1000
    }
}
