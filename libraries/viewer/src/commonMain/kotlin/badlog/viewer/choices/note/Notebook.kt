package badlog.viewer.choices.note

/**
 * The notes of a log, and the one that a person is writing. Immutable; each step returns another one.
 *
 * @property notes the notes, in the order of x.
 * @property draft the note that is being written or changed; null for none.
 */
data class Notebook(val notes: List<Note> = emptyList(), val draft: NoteDraft? = null) {
    /** Why there cannot be one more note, as a sentence; null if there can. */
    val fullness: String?
        get() = if (notes.size < Note.MAX_NOTES) null else "This log has ${Note.MAX_NOTES} notes; remove one first."

    /** Begins a note at [x]. */
    fun begun(x: Double): Notebook = copy(draft = NoteDraft(x, "", null))

    /** Begins to change [note]. */
    fun changing(note: Note): Notebook = copy(draft = NoteDraft(note.x, note.text, note))

    /** Sets the text of the draft; what is longer than a note can be is cut off. */
    fun typed(text: String): Notebook = copy(draft = draft?.copy(text = text.take(Note.MAX_TEXT)))

    /** Discards the draft. */
    fun cancelled(): Notebook = copy(draft = null)

    /** Puts the draft among the notes, or in the place of the one that it changes; a draft without text is discarded. */
    fun kept(): Notebook {
        val written = draft ?: return this
        if (written.text.isBlank()) return cancelled()
        return Notebook(inOrder(notes - setOfNotNull(written.replaced) + Note(written.x, written.text.trim())))
    }

    /** Removes [note]. */
    fun without(note: Note): Notebook = copy(notes = notes - note)

    /** Takes back that [note] was removed. */
    fun restored(note: Note): Notebook = if (note in notes) this else with(notes + note)

    /** Shows [notes] instead, for example because another window has changed them; the draft stays. */
    fun with(notes: List<Note>): Notebook = copy(notes = inOrder(notes))

    private fun inOrder(notes: List<Note>) = notes.sortedBy { it.x }
}

/**
 * A note that is being written.
 *
 * @property x its moment, in the unit of the log's x axis.
 * @property text what is written so far; may be empty.
 * @property replaced the note that it changes; null for a new one.
 */
data class NoteDraft(val x: Double, val text: String, val replaced: Note?)

/** What is said when the note at the time [moment] was removed. */
fun removedText(moment: String): String = "The note at $moment was removed."
