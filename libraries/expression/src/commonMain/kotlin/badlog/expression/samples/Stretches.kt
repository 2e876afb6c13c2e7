package badlog.expression.samples

import badlog.core.analysis.Series
import kotlin.math.ulp

/**
 * The time of a recording with a clock that was set back, as a sequence of stretches in which it goes forward. Expressions use a continuous
 * clock, on which later samples also have later times. Times are shown as they were logged.
 *
 * @param positions the x of each row; may hold gaps.
 */
class Stretches internal constructor(positions: DoubleArray) {
    private val rows = if (positions.all { it.isFinite() }) positions else positions.filter { it.isFinite() }.toDoubleArray()

    // Each stretch's first row, and its lead over the continuous clock. Then that clock's first and last time in it.
    private val firstRows = ArrayList<Int>()
    private val leads = ArrayList<Double>()
    private val begins = ArrayList<Double>()
    private val ends = ArrayList<Double>()

    private val steady = DoubleArray(rows.size)
    private val steadyOf = HashMap<DoubleArray, DoubleArray>()
    private val loggedOf = HashMap<DoubleArray, DoubleArray>()

    init {
        val scale = if (rows.isEmpty()) 1.0 else rows.max() - rows.min()
        var size = 0
        for (row in positions.indices) {
            val time = positions[row]
            if (!time.isFinite()) continue
            if (size == 0) {
                begin(row, time, 0.0)
            } else if (time < rows[size - 1]) {
                begin(row, time, after(steady[size - 1], scale))
            }
            steady[size] = time - leads.last()
            ends[ends.lastIndex] = steady[size++]
        }
        keep(rows, steady)
    }

    private fun begin(row: Int, logged: Double, time: Double) {
        firstRows += row
        leads += logged - time
        begins += logged - leads.last()
        ends += begins.last()
    }

    /** The first time of the recording. */
    internal val begin: Double get() = begins.firstOrNull() ?: Double.POSITIVE_INFINITY

    /** The last time of the recording, on the continuous clock. */
    internal val end: Double get() = ends.lastOrNull() ?: Double.NEGATIVE_INFINITY

    internal val count: Int get() = leads.size

    internal fun knows(logged: DoubleArray): Boolean = logged in steadyOf

    /** Records that [logged] has the times of [rows], which ascend. */
    internal fun keepRows(logged: DoubleArray, rows: List<Int>) {
        var stretch = 0
        val times = DoubleArray(logged.size) {
            while (stretch + 1 < count && rows[it] >= firstRows[stretch + 1]) stretch++
            logged[it] - leads[stretch]
        }
        keep(logged, times)
    }

    private fun keep(logged: DoubleArray, onSteady: DoubleArray) {
        steadyOf[logged] = onSteady
        loggedOf[onSteady] = logged
    }

    /**
     * Returns [logged] on the continuous clock. Times of unknown rows belong to the first stretch that has them, but never to a stretch
     * before the previous sample's.
     */
    internal fun steady(logged: DoubleArray): DoubleArray {
        steadyOf[logged]?.let { return it }
        var stretch = 0
        val times = DoubleArray(logged.size) {
            if (it > 0 && logged[it] < logged[it - 1] && stretch + 1 < count) stretch++
            while (stretch + 1 < count && logged[it] > lastOf(stretch)) stretch++
            logged[it] - leads[stretch]
        }
        // Times that go back more often than the rows have no stretch of their own.
        for (i in 1 until times.size) if (times[i] < times[i - 1]) times[i] = times[i - 1]
        keep(logged, times)
        return times
    }

    /** Returns the logged times of [steady]. If [steady] was made from an array of logged times, returns that array. */
    internal fun logged(steady: DoubleArray): DoubleArray = loggedOf[steady] ?: DoubleArray(steady.size) { logged(steady[it]) }
        .also { keep(it, steady) }

    /** Returns the logged time for [time] on the continuous clock. */
    internal fun logged(time: Double): Double {
        if (time.isNaN()) return time
        val row = firstNotBefore(time)
        return if (row < rows.size && steady[row] == time) rows[row] else time + leads[stretchOf(time)]
    }

    private fun firstNotBefore(time: Double): Int {
        var low = 0
        var high = steady.size
        while (low < high) {
            val middle = (low + high) ushr 1
            if (steady[middle] < time) low = middle + 1 else high = middle
        }
        return low
    }

    /** Returns whether the clock was set back between [earlier] and [later] on the continuous clock. */
    internal fun isSetBackBetween(earlier: Double, later: Double): Boolean = stretchOf(earlier) != stretchOf(later)

    private fun stretchOf(time: Double): Int {
        val found = begins.binarySearch(time)
        return if (found >= 0) found else maxOf(0, -found - 2)
    }

    private fun firstOf(stretch: Int) = begins[stretch] + leads[stretch]

    private fun lastOf(stretch: Int) = ends[stretch] + leads[stretch]

    /** Calls [part] for each part of the time from [from] to [to], as it was logged. */
    internal fun eachPart(from: Double, to: Double, part: (from: Double, to: Double) -> Unit) {
        val first = stretchOf(from)
        for (stretch in first until count) {
            if (stretch > first && begins[stretch] >= to) break
            val isLast = stretch + 1 == count || (begins[stretch + 1] >= to && ends[stretch] >= to)
            val begin = if (stretch == first) logged(from) else firstOf(stretch)
            part(begin, maxOf(begin, if (isLast) logged(to) else lastOf(stretch)))
        }
    }

    /**
     * Returns the samples of [column] at the same times on this clock: each stretch gets the samples of its times. [column] has another
     * clock, which was never set back.
     */
    internal fun spread(column: Column): Column {
        val own = Series(column.x, column.y)
        val times = ArrayList<Double>()
        val samples = ArrayList<Double>()
        for (stretch in 0 until count) {
            val inside = when {
                stretch == 0 -> 0
                column.isMomentary -> own.firstAtOrAfter(firstOf(stretch))
                else -> own.firstAfter(firstOf(stretch))
            }
            if (stretch > 0 && !column.isMomentary) {
                times += begins[stretch]
                samples += if (inside == 0) Double.NaN else column.y[inside - 1]
            }
            for (i in inside until column.size) {
                if (stretch + 1 < count && column.x[i] > lastOf(stretch)) break
                times += column.x[i] - leads[stretch]
                samples += column.y[i]
            }
        }
        return Column(times.toDoubleArray(), samples.toDoubleArray(), column.texts, column.isMomentary, this)
    }

    /** Returns, for each row of [positions], the last sample of [series] up to then. */
    internal fun inRows(series: Series, positions: DoubleArray): Series {
        if (series.x === positions) return series
        val held = if (knows(series.x) || !series.isOrdered) Column(steady(series.x), series.y) else spread(Column(series.x, series.y))
        var next = 0
        var place = 0
        val samples = DoubleArray(positions.size) { row ->
            if (!positions[row].isFinite()) return@DoubleArray Double.NaN
            val time = steady[place++]
            while (next < held.size && held.x[next] <= time) next++
            if (next == 0) Double.NaN else held.y[next - 1]
        }
        return Series(positions, samples)
    }

    internal companion object {
        /** Returns the stretches of [positions]; null if they never decrease. */
        fun of(positions: DoubleArray): Stretches? {
            var last = Double.NEGATIVE_INFINITY
            for (position in positions) {
                if (position < last) return Stretches(positions)
                if (position.isFinite()) last = position
            }
            return null
        }
    }
}

// Later by a negligible amount: a power of two, which keeps round times round.
private fun after(time: Double, scale: Double) = time + maxOf(time, scale, 1e-9).ulp * 1024
