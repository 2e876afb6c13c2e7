package badlog.core.bag

import badlog.core.text.COMMA
import badlog.core.text.TAB
import badlog.core.text.originOf

/**
 * The differences between a CSV file and the usual form: cells separated by commas, and decimal points.
 *
 * @property separator the byte between two cells.
 * @property hasComma whether numbers have decimal commas.
 * @property between the character between thousands; null if there is none.
 * @property clocks for each column of times of day, by its index, the µs in one unit; [ISO_CLOCK] for times in ISO 8601.
 * @property hasTitles whether the first line has the titles.
 * @property isNamed whether the file's first line names the separator, as Excel's does.
 */
internal class CsvDialect(
    val separator: Int = COMMA,
    val hasComma: Boolean = false,
    val between: Char? = null,
    val clocks: Map<Int, Double> = emptyMap(),
    val hasTitles: Boolean = true,
    val isNamed: Boolean = false,
) {
    /** Whether nothing differs. */
    val isUsual: Boolean get() = separator == COMMA && !hasComma && between == null && clocks.isEmpty()

    /** A sentence about the differences in all cells; null if there are none. */
    val sentence: String?
        get() {
            val parts = buildList {
                if (separator != COMMA) add("columns are separated by ${separatorName()}")
                if (hasComma) add("numbers have decimal commas")
                if (between != null) add("numbers have ${nameOf(between)} between thousands")
            }
            if (parts.isEmpty()) return null
            val text = if (parts.size == 1) parts[0] else parts.dropLast(1).joinToString() + " and " + parts.last()
            return text.replaceFirstChar(Char::uppercaseChar) + "; the file was read that way."
        }

    private fun separatorName() = when (separator) {
        ';'.code -> "semicolons"
        TAB -> "tabs"
        else -> "“${separator.toChar()}”"
    }

    private fun nameOf(mark: Char) = when (mark) {
        '.' -> "points"
        ',' -> "commas"
        ' ' -> "spaces"
        else -> "apostrophes"
    }
}

/** The clock of a column with times in ISO 8601, which do not count in a unit. */
internal const val ISO_CLOCK = 0.0

/** Returns the number of µs in the unit of [number], a time since 1970. Null if it is not a time in s, ms, µs or ns. */
internal fun clockOf(number: Double): Double? = CLOCKS.find { originOf(number * it) > 0 }

private val CLOCKS = listOf(1e6, 1e3, 1.0, 1e-3)
