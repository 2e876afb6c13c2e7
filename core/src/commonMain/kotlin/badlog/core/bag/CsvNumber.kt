package badlog.core.bag

/**
 * A number as a person or a spreadsheet writes it. It has digits with marks between them, such as `1.234,5`, `12 345` or `0,02`.
 *
 * @param parts the digits between the marks.
 * @param marks the marks, each a point, a comma, a space or an apostrophe.
 */
internal class CsvNumber private constructor(
    private val sign: String,
    private val parts: List<String>,
    private val marks: List<Char>,
    private val exponent: String,
) {
    /** The mark that can only separate thousands; null if there is none, or if that is not clear. */
    val grouping: Char?
        get() = when {
            marks.isEmpty() -> null
            marks.size == 1 -> marks[0].takeIf { it !in POINTS && isGrouped(parts) }
            marks.all { it == marks[0] } -> marks[0].takeIf { isGrouped(parts) }
            else -> groupedBeforePoint()
        }

    /** The mark that can only be the decimal mark; null if there is none, or if that is not clear. */
    val point: Char?
        get() = when {
            marks.size == 1 -> marks[0].takeIf { it in POINTS && !mayBeGrouped }
            groupedBeforePoint() != null -> marks.last()
            else -> null
        }

    /** Whether several marks leave no doubt about [grouping]. */
    val isSurelyGrouped: Boolean get() = marks.size > 1 && grouping != null

    /** Whether its only mark may be either a decimal mark or one between thousands: `1,234`. */
    val mayBeGrouped: Boolean get() = marks.size == 1 && marks[0] in POINTS && exponent.isEmpty() && isGrouped(parts)

    /** The only mark if it [may be grouped][mayBeGrouped]. */
    val openMark: Char? get() = if (mayBeGrouped) marks[0] else null

    /** Whether it is a number under any reading. */
    val isPossible: Boolean get() = marks.isEmpty() || grouping != null || point != null || mayBeGrouped

    /**
     * Returns the number in the form that programs write, or null if it is not a number in this reading. [between] is the mark between
     * thousands; null for none.
     */
    fun text(between: Char?, isComma: Boolean): String? {
        fun isPoint(mark: Char) = mark != between && (mark == '.' || (mark == ',' && isComma))
        val whole = when {
            marks.isEmpty() -> parts[0]
            marks.size == 1 && isPoint(marks[0]) -> return sign + parts[0] + "." + parts[1] + exponent
            between == null -> return null
            marks.all { it == between } -> if (isGrouped(parts)) parts.joinToString("") else return null
            groupedBeforePoint() != between || !isPoint(marks.last()) -> return null
            else -> return sign + parts.dropLast(1).joinToString("") + "." + parts.last() + exponent
        }
        return sign + whole + exponent
    }

    private fun groupedBeforePoint(): Char? {
        if (marks.size < 2 || marks.last() !in POINTS || marks.last() == marks[0]) return null
        return marks[0].takeIf { first -> marks.dropLast(1).all { it == first } && isGrouped(parts.dropLast(1)) }
    }

    companion object {
        private const val POINTS = ".,"
        private const val MARKS = "., '"

        /** The maximum length of a cell with a number. */
        const val MAX_LENGTH = 48
        private val HARD_SPACES = listOf("\u00c2\u00a0", "\u00e2\u0080\u00af", "\u00a0")

        private fun isGrouped(parts: List<String>): Boolean =
            parts.size > 1 && parts[0].length in 1..3 && parts[0][0] != '0' && parts.drop(1).all { it.length == 3 }

        /** Returns the number in [cell], which has one character for each byte; null if there is none. */
        fun of(cell: String): CsvNumber? {
            if (cell.length > MAX_LENGTH) return null
            var text = cell.trim()
            for (space in HARD_SPACES) text = text.replace(space, " ")
            val sign = if (text.startsWith('-') || text.startsWith('+')) text.take(1) else ""
            val rest = text.drop(sign.length)
            val end = rest.indexOfFirst { it == 'e' || it == 'E' }.let { if (it < 0) rest.length else it }
            val exponent = rest.substring(end)
            if (exponent.isNotEmpty() && !isExponent(exponent)) return null
            val digits = rest.substring(0, end)
            if (digits.none { it in '0'..'9' } || digits.any { it !in '0'..'9' && it !in MARKS }) return null
            return CsvNumber(sign, digits.split('.', ',', ' ', '\''), digits.filter { it in MARKS }.toList(), exponent)
        }

        private fun isExponent(text: String): Boolean {
            val from = if (text.length > 1 && text[1] in "+-") 2 else 1
            return text.length > from && text.drop(from).all { it in '0'..'9' }
        }
    }
}
