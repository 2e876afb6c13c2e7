package badlog.viewer.draw.pen

/** Returns [text], or its beginning and `…` if it is wider than [room]. */
fun Pen.fittedStart(text: String, room: Double, letters: Double, isBold: Boolean = false): String =
    fitted(text, room, letters, isBold) { text.take(it) + "…" }

/** Returns [text], or both its ends with `…` between if it is wider than [room]. Names often differ only at their ends. */
fun Pen.fittedEnds(text: String, room: Double, letters: Double): String = fitted(text, room, letters, isBold = false) { length ->
    text.take(length / 2) + "…" + text.takeLast(length - length / 2)
}

private fun Pen.fitted(text: String, room: Double, letters: Double, isBold: Boolean, cut: (Int) -> String): String {
    if (widthOf(text, letters, isBold) <= room) return text
    var fits = 0
    var tooLong = text.length
    while (tooLong - fits > 1) {
        val length = (fits + tooLong) / 2
        if (widthOf(cut(length), letters, isBold) <= room) fits = length else tooLong = length
    }
    return cut(fits)
}
