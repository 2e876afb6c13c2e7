package badlog.viewer.choices.note

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
