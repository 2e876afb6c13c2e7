package badlog.core.bag

import badlog.core.text.COMMA

/**
 * The differences between a CSV file and the usual form: cells separated by commas, and decimal points.
 *
 * @property separator the byte between two cells.
 * @property hasComma whether numbers have decimal commas.
 * @property between the mark between thousands, a character; null if there is none.
 * @property clocks the notation of each column of times of day, by the column's index.
 * @property hasTitles whether the first line is titles.
 * @property isNamed whether the file's first line names the separator, as Excel's does.
 */
internal class CsvDialect(
    val separator: Int = COMMA,
    val hasComma: Boolean = false,
    val between: Char? = null,
    val clocks: Map<Int, CsvClock> = emptyMap(),
    val hasTitles: Boolean = true,
    val isNamed: Boolean = false,
) {
    /** Whether nothing differs. */
    val isUsual: Boolean get() = separator == COMMA && !hasComma && between == null && clocks.isEmpty()

    /** A sentence about the differences in all cells; null if there are none. */
    val sentence: String?
        get() {
            val parts = buildList {
                if (separator != COMMA) add("columns are separated by ${if (separator == ';'.code) "semicolons" else "tabs"}")
                if (hasComma) add("numbers have decimal commas")
                if (between != null) add("numbers have ${nameOf(between)} between thousands")
            }
            if (parts.isEmpty()) return null
            val text = if (parts.size == 1) parts[0] else parts.dropLast(1).joinToString() + " and " + parts.last()
            return text.replaceFirstChar(Char::uppercaseChar) + "; the file was read that way."
        }

    private fun nameOf(mark: Char) = when (mark) {
        '.' -> "points"
        ',' -> "commas"
        ' ' -> "spaces"
        else -> "apostrophes"
    }
}

/** The notation of times of day in a column. */
internal enum class CsvClock(val microsEach: Double) {
    /** As in ISO 8601. */
    ISO(0.0),
    SECONDS(1e6),
    MILLISECONDS(1e3),
    MICROSECONDS(1.0),
    NANOSECONDS(1e-3),
    ;

    companion object {
        /** September 2001 and the end of 2096, in s since 1970. */
        private const val FIRST = 1e9
        private const val LAST = 4e9

        /** Returns the unit in which [number] is a time since 1970; null if there is none. */
        fun of(number: Double): CsvClock? = entries.find { it != ISO && number * it.microsEach / 1e6 in FIRST..LAST }
    }
}
