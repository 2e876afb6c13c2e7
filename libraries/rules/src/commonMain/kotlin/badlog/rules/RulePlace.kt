package badlog.rules

/**
 * The place of a text in a file of rules.
 *
 * @property lineNumber the number of the line, counted from 1.
 * @property line the whole line.
 * @property column the place in [line] where the text begins, counted from 0.
 * @property literal the text, if the file contains it literally; otherwise null.
 */
internal class RulePlace(val lineNumber: Int, val line: String, val column: Int, val literal: String?) {
    /** Returns [message] about the text from [from] until [until], with the line and carets below it. */
    fun pointed(message: String, from: Int = 0, until: Int = literal?.length ?: 1): String {
        val begin = minOf(line.length, if (literal != null) column + from else column)
        val carets = if (literal != null) (until - from).coerceIn(1, maxOf(1, line.length - begin)) else 1
        val shown = line.map { if (it.isISOControl()) ' ' else it }.joinToString("")
        return "Line $lineNumber: $message\n$shown\n${" ".repeat(begin)}${"^".repeat(carets)}"
    }
}
