package badlog.cli.text

import badlog.files.terminal.displayWidth
import badlog.files.terminal.printable
import badlog.files.terminal.startOf

/** The minimum width of a terminal. */
internal const val LINE_WIDTH = 80

/**
 * Returns [first], then [text], in lines of [width]. Lines are broken between words, or inside a word longer than a line; further lines are
 * indented by [indent].
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
