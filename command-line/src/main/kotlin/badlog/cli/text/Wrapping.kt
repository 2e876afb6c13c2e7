package badlog.cli.text

import badlog.terminal.displayWidth
import badlog.terminal.printable
import badlog.terminal.startOf

/** How wide a terminal is, at the least. */
internal const val LINE_WIDTH = 80

/**
 * [first], then [text] in lines of [width] that are broken between words, or inside one that is longer than a line; the second
 * and later lines stand [indent] to the right.
 */
internal fun wrapped(first: String, text: String, indent: Int = displayWidth(first), width: Int = LINE_WIDTH): String {
    val lines = WrappedLines(first, indent, width)
    printable(text).split(' ').forEach(lines::add)
    return lines.toString()
}

private class WrappedLines(first: String, private val indent: Int, private val width: Int) {
    private val out = StringBuilder(first)
    private var at = displayWidth(first)
    private var isStart = true

    fun add(word: String) {
        var rest = word
        while (at + gap() + displayWidth(rest) > width) {
            val room = width - at - gap()
            if (displayWidth(rest) > width - indent) {
                val start = startOf(rest, room)
                if (start.isNotEmpty()) append(start)
                rest = rest.drop(start.length)
            }
            breakLine()
        }
        append(rest)
    }

    private fun gap() = if (isStart) 0 else 1

    private fun append(text: String) {
        if (!isStart) out.append(' ')
        out.append(text)
        at += gap() + displayWidth(text)
        isStart = false
    }

    private fun breakLine() {
        out.append('\n').append(" ".repeat(indent))
        at = indent
        isStart = true
    }

    override fun toString() = out.toString()
}
