package badlog.viewer.shown.cursor

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import kotlin.math.abs

/**
 * Decides which of many lines are first at a cursor.
 *
 * @param lines the lines, in their default order.
 * @param axis the lines' x axis.
 */
class CursorValues(private val lines: List<GraphSeries>, axis: XAxis) {
    private val reach = reachOn(axis)

    /**
     * The difference between the largest and the smallest number of each line. 0 for states, and for fewer than two numbers. NaN until
     * needed.
     */
    private val ranges = DoubleArray(lines.size) { Double.NaN }

    /**
     * Returns the lines at [x], the ones that changed within 0.1 s of it first. Of these, states come before numbers, which are sorted by
     * their change as a fraction of their whole range. The others follow in order. A number counts as changed above 2 % of its range,
     * because otherwise noise would be first.
     */
    fun at(x: Double): List<CursorValue> {
        val values = lines.indices.map { CursorValue(it, changeAt(it, x)) }
        val (changed, others) = values.partition { it.hasChanged }
        return changed.sortedByDescending { it.change } + others
    }

    private fun changeAt(index: Int, x: Double): Double {
        val line = lines[index]
        val data = line.data
        if (!data.isOrdered || x.isNaN()) return 0.0
        // Includes the value that still held at the start. Otherwise the first of a few samples would not be a change.
        var at = data.firstAtOrAfter(x - reach).let { if (it > 0) it - 1 else it }
        var least = Double.POSITIVE_INFINITY
        var most = Double.NEGATIVE_INFINITY
        while (at < data.size && data.x[at] <= x + reach) {
            val value = data.y[at++]
            if (!value.isFinite()) continue
            least = minOf(least, value)
            most = maxOf(most, value)
        }
        val change = most - least
        return when {
            !(change > 0) -> 0.0
            line.states != null -> STATE
            else -> change / rangeOf(index)
        }
    }

    private fun rangeOf(index: Int): Double {
        if (ranges[index].isNaN()) {
            var least = Double.POSITIVE_INFINITY
            var most = Double.NEGATIVE_INFINITY
            for (value in lines[index].data.y) {
                if (!value.isFinite()) continue
                if (value < least) least = value
                if (value > most) most = value
            }
            ranges[index] = most - least
        }
        return ranges[index]
    }

    private companion object {
        /** The change of a state, larger than any fraction of a range. */
        const val STATE = 2.0
        const val SECONDS = 0.1

        /** The same reach in rows, for rows that are logged in a robot's loop. */
        const val ROWS = 5.0

        /** The reach as a fraction of the range of x, if x may not be a time. */
        const val PART = 0.001

        fun reachOn(axis: XAxis): Double {
            val seconds = Units.secondsIn(axis.unit)
            val range = axis.range
            return when {
                axis.isIndex -> ROWS
                seconds != null -> abs(SECONDS / seconds)
                range != null -> (range.endInclusive - range.start) * PART
                else -> 0.0
            }
        }
    }
}

/**
 * A line at a cursor.
 *
 * @property line the index of the line.
 * @property change the change at the cursor as a fraction of the line's range; 0 if there is none.
 */
class CursorValue(val line: Int, val change: Double) {
    /** Whether the line changed by more than noise at the cursor. */
    val hasChanged: Boolean get() = change > NOISE

    private companion object {
        const val NOISE = 0.02
    }
}
