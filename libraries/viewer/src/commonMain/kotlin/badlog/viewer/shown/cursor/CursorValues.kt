package badlog.viewer.shown.cursor

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Series
import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import badlog.signals.pose.lastAtOrBefore
import badlog.viewer.choices.range.wholeRange
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit
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
}

/**
 * Returns the announcement of a screen reader when a key has moved a cursor to [x]. It has [place], the text of x, and the first values of
 * [lines] there.
 */
fun spokenAt(lines: List<GraphSeries>, x: Double, place: String): String {
    val values = lines.take(MAX_SPOKEN).mapNotNull { line ->
        val text = line.textOf(line.indexAt(x)) { withUnit(numberText(it), line.unit) }
        if (text.isEmpty()) null else "${line.name} $text"
    }
    return (listOf(place) + values).joinToString(", ")
}

private const val MAX_SPOKEN = 4

/**
 * Returns the index of the sample that a cursor at [x] reads on this line; -1 outside the line's recording, or if [x] is NaN.
 *
 * All front ends share this rule. Values that hold until they change, such as states and topics with times of their own, are read from
 * the last sample at or before the cursor, so nothing is read before the first sample. Numbers that were measured row by row, and
 * calculated ones, are read from the nearest sample, on which the cursor's dot is drawn.
 */
fun GraphSeries.indexAt(x: Double): Int = when {
    x !in wholeRange -> -1
    states != null || holds -> data.lastAtOrBefore(x)
    else -> data.nearest(x)
}

/**
 * Returns the x of a cursor's dot on this line, for a cursor at [x]. It is at the cursor if the value holds, otherwise at the sample. NaN
 * if there is none.
 */
fun GraphSeries.dotAt(x: Double): Double {
    val index = indexAt(x)
    return if (index < 0) {
        Double.NaN
    } else if (holds) {
        x
    } else {
        data.x[index]
    }
}

/**
 * Returns sample [index] of this line as text: the name of its state, or its number formatted by [sampleText]. `–` for a gap, and for an
 * index without a sample.
 */
fun GraphSeries.textOf(index: Int, sampleText: (Double) -> String = ::numberText): String {
    if (index !in 0 until data.size) return NOTHING
    val value = data.y[index]
    if (value.isNaN()) return NOTHING
    return states?.let { it.getOrElse(value.toInt()) { "?" } } ?: sampleText(value)
}

private const val NOTHING = "–"

/**
 * The places on x that the cursor steps to: places with a sample, each once.
 *
 * @param clocks every x with a sample, see [badlog.core.analysis.XAxis.clocks]; may have gaps, and may go backwards. Evaluated at the
 *   first step.
 */
class CursorSteps(clocks: List<DoubleArray>) {
    private val places: List<Series> by lazy { clocks.map(::ascending).filter { it.size > 0 } }

    /** Returns the place nearest to [x]; NaN if there are no samples. */
    fun nearest(x: Double): Double {
        var nearest = Double.NaN
        for (clock in places) {
            val place = clock.x[clock.nearest(x)]
            if (nearest.isNaN() || abs(place - x) < abs(nearest - x)) nearest = place
        }
        return nearest
    }

    /**
     * Returns the place [count] steps after [x], or before it if negative. The steps end at the last and the first place. NaN if there
     * are no samples.
     */
    fun from(x: Double, count: Int): Double {
        if (places.isEmpty()) return Double.NaN
        var place = x
        repeat(abs(count)) { place = if (count > 0) after(place) else before(place) }
        return place
    }

    private fun after(x: Double): Double {
        var next = Double.POSITIVE_INFINITY
        for (clock in places) {
            val index = clock.firstAfter(x)
            if (index < clock.size) next = minOf(next, clock.x[index])
        }
        return if (next.isFinite()) next else places.maxOf { it.x.last() }
    }

    private fun before(x: Double): Double {
        var next = Double.NEGATIVE_INFINITY
        for (clock in places) {
            val index = clock.firstAtOrAfter(x) - 1
            if (index >= 0) next = maxOf(next, clock.x[index])
        }
        return if (next.isFinite()) next else places.minOf { it.x.first() }
    }
}

private fun ascending(positions: DoubleArray): Series {
    val whole = Series(positions, positions)
    var isWhole = whole.isOrdered
    for (x in positions) if (!x.isFinite()) isWhole = false
    if (isWhole) return whole
    var count = 0
    val finite = DoubleArray(positions.size)
    for (x in positions) if (x.isFinite()) finite[count++] = x
    val sorted = finite.copyOf(count)
    sorted.sort()
    return Series(sorted, sorted)
}

private const val NOISE = 0.02
