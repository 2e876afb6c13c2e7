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
