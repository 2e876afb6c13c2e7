package badlog.cli.text

/** How wide a terminal is, at the least. */
internal const val LINE_WIDTH = 80

/**
 * [first], then [text] in lines of [width] that are broken between words, or inside one that is longer than a line; the second
 * and later lines stand [indent] to the right.
 */
internal fun wrapped(first: String, text: String, indent: Int = first.length, width: Int = LINE_WIDTH): String {
    val lines = WrappedLines(first, indent, width)
    printable(text).split(' ').forEach(lines::add)
    return lines.toString()
}

/** [text] without what would move a terminal's cursor, or change its colours: names and texts come from files. */
internal fun printable(text: String): String =
    if (text.none { it.isISOControl() }) text else text.map { if (it.isISOControl()) ' ' else it }.joinToString("")

private class WrappedLines(first: String, private val indent: Int, private val width: Int) {
    private val out = StringBuilder(first)
    private var at = first.length
    private var isStart = true

    fun add(word: String) {
        var rest = word
        while (at + gap() + rest.length > width) {
            val room = width - at - gap()
            if (rest.length > width - indent && room > 0) {
                append(rest.take(room))
                rest = rest.drop(room)
            }
            breakLine()
        }
        append(rest)
    }

    private fun gap() = if (isStart) 0 else 1

    private fun append(text: String) {
        if (!isStart) out.append(' ')
        out.append(text)
        at += gap() + text.length
        isStart = false
    }

    private fun breakLine() {
        out.append('\n').append(" ".repeat(indent))
        at = indent
        isStart = true
    }

    override fun toString() = out.toString()
}
