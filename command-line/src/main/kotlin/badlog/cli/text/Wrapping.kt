package badlog.cli.text

/** How wide a terminal is, at the least. */
internal const val LINE_WIDTH = 80

/** [text] in lines of [width], broken between words, the second and later ones [indent] to the right; [first] before it. */
internal fun wrapped(first: String, text: String, indent: Int = first.length, width: Int = LINE_WIDTH): String {
    val out = StringBuilder(first)
    var at = first.length
    var isStart = true
    val words = printable(text).split(' ').flatMap { if (it.length > width - indent) it.chunked(width - indent) else listOf(it) }
    for (word in words) {
        if (!isStart && at + 1 + word.length > width) {
            out.append('\n').append(" ".repeat(indent))
            at = indent
            isStart = true
        }
        if (!isStart) {
            out.append(' ')
            at++
        }
        out.append(word)
        at += word.length
        isStart = false
    }
    return out.toString()
}

/** [text] without what would move a terminal's cursor, or change its colours: names and texts come from files. */
internal fun printable(text: String): String =
    if (text.none { it.isISOControl() }) text else text.map { if (it.isISOControl()) ' ' else it }.joinToString("")
