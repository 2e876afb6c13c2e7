package badlog.viewer.choices.note

/** Returns these notes with a mark at [x]. The mark is a note with a numbered text, such as `Mark 3`, which can be changed later. */
fun Notebook.marked(x: Double): Notebook {
    val last = notes.mapNotNull { MARK.matchEntire(it.text)?.groupValues?.get(1)?.toInt() }.maxOrNull() ?: 0
    return with(notes + Note(x, "Mark ${last + 1}"))
}

/** Returns the message about a mark that was added at [place], such as `12.3 s`. */
fun markedText(place: String): String = "Marked at $place; the mark is a note, whose text you can change."

private val MARK = Regex("Mark (\\d{1,6})")
