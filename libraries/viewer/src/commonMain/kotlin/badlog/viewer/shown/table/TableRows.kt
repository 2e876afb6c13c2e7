package badlog.viewer.shown.table

import badlog.core.analysis.Span
import badlog.core.analysis.periodicTimes
import kotlin.math.floor

/**
 * The rows of a table for topics that do not share rows.
 *
 * @property remark the way they were made, to append to a sentence.
 */
class TableRows(val times: DoubleArray, val remark: String) {
    companion object {
        /**
         * Makes rows in [range] for [columns] topics: one every 20 ms, as often as a robot's program runs. If [samples], the times of the
         * topic [densest], are more, makes a row at each of them.
         */
        fun of(range: Span, columns: Int, densest: String?, samples: DoubleArray): TableRows {
            // Many topics over many hours would be more than any spreadsheet can open, and need more memory than there is.
            val most = MAX_CELLS / (columns + 1)
            val period = generateSequence(PERIOD) { it * 2 }.first { range.width / it < most }
            val periodic = floor(range.width / period + ROUNDING).toInt() + 1
            val own = samples.filter { it in range }.distinct().sorted()
            if (own.size > periodic && own.size < most) return TableRows(own.toDoubleArray(), ", one at each sample of “$densest”$HELD")
            return TableRows(periodicTimes(range.from, period, periodic), ", one every ${(period * 1000).toInt()} ms$HELD")
        }

        private const val HELD = ", each with the last values before it"

        /** The time between two rows, in seconds. */
        private const val PERIOD = 0.02
        private const val MAX_CELLS = 40e6

        // The tolerance, in periods, for the last step of a period that divides the range.
        private const val ROUNDING = 1e-9
    }
}

/** Returns the rows from the first to the last in [span]. Rows between them belong to it even if x is missing or goes backward. */
fun rowsWithin(positions: DoubleArray, span: Span): IntRange {
    val first = positions.indexOfFirst { it in span }
    return if (first < 0) IntRange.EMPTY else first..positions.indexOfLast { it in span }
}
