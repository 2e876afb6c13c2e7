package badlog.plot.cursor

import badlog.analysis.GraphSeries
import badlog.analysis.Units
import badlog.analysis.XAxis
import kotlin.math.abs

/**
 * What to read first of many lines at a cursor.
 *
 * @param lines the lines, in the order in which they are shown where nothing happens.
 * @param axis their x axis.
 */
public class CursorValues(private val lines: List<GraphSeries>, axis: XAxis) {
    private val reach = reachOn(axis)

    /** How far apart the smallest and the largest number of each line are; 0 for states, and where there are no two. NaN before it is asked for. */
    private val ranges = DoubleArray(lines.size) { Double.NaN }

    /**
     * The lines at [x]: first those that changed within 0.1 s of it, states and then what changed by the largest part of its whole range;
     * then all others in their order. A number has changed where that part is above 2 %, else noise would come first.
     */
    public fun at(x: Double): List<CursorValue> {
        val values = lines.indices.map { CursorValue(it, changeAt(it, x)) }
        val (changed, others) = values.partition { it.hasChanged }
        return changed.sortedByDescending { it.change } + others
    }

    private fun changeAt(index: Int, x: Double): Double {
        val line = lines[index]
        val data = line.data
        if (!data.isOrdered || x.isNaN()) return 0.0
        // What still held as it began counts, else the first of few samples would be no change.
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
        /** Above every part of a range. */
        const val STATE = 2.0
        const val SECONDS = 0.1

        /** So many rows are about as long in a robot's loop. */
        const val ROWS = 5.0

        /** A part of an x that nobody knows to be a time. */
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
 * @property line its place among the lines.
 * @property change how much of its range it went through there; 0 where it stayed as it was.
 */
public class CursorValue(public val line: Int, public val change: Double) {
    /** Whether it changed there by more than noise does. */
    public val hasChanged: Boolean get() = change > NOISE

    private companion object {
        const val NOISE = 0.02
    }
}
