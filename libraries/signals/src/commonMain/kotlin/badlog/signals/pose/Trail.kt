package badlog.signals.pose

import badlog.core.analysis.Series
import badlog.core.analysis.Span

/**
 * The places of something over time: sample `i` is `(x[i], y[i])` at [times]`[i]`.
 *
 * @property times the times; usually ascending.
 * @property x NaN where it is not known; [y] may be known there or not.
 */
class Trail(val times: DoubleArray, val x: DoubleArray, val y: DoubleArray) {
    private val clock = Series(times, x)

    /** The number of samples, gaps included. */
    val size: Int get() = times.size

    /** The range of x over samples where both are finite; null if there are none. */
    val xSpan: Span? by lazy { spanOf(x) }

    /** The range of y over the same samples; null if there are none. */
    val ySpan: Span? by lazy { spanOf(y) }

    /** Returns the index of the last sample at or before [time]; -1 if there is none. */
    fun indexAt(time: Double): Int = if (time.isNaN()) -1 else clock.lastAtOrBefore(time)

    /**
     * Returns the index of the first sample in [visible]. All samples from there until [endOf] are in it, unless the clock goes back
     * somewhere.
     */
    fun startOf(visible: Span): Int = if (clock.isOrdered) clock.firstAtOrAfter(visible.from) else 0

    /** Returns the index after the last sample in [visible]. */
    fun endOf(visible: Span): Int = if (clock.isOrdered) clock.firstAfter(visible.to) else size

    /** Returns whether sample [index] has a place: both coordinates are finite. */
    fun isPlace(index: Int): Boolean = x[index].isFinite() && y[index].isFinite()

    private fun spanOf(values: DoubleArray): Span? {
        var least = Double.POSITIVE_INFINITY
        var most = Double.NEGATIVE_INFINITY
        for (i in values.indices) {
            if (!isPlace(i)) continue
            if (values[i] < least) least = values[i]
            if (values[i] > most) most = values[i]
        }
        return if (least <= most) Span(least, most) else null
    }
}

/**
 * Returns the samples of [x] and [y] at the same time, each multiplied by [scale]. If they do not share their times, there is a sample at
 * each time of either, with the last value of the other.
 */
fun trailOf(x: Series, y: Series, scale: Double = 1.0): Trail {
    fun scaled(values: DoubleArray) = if (scale == 1.0) values else DoubleArray(values.size) { values[it] * scale }
    if (x.x === y.x || x.x.contentEquals(y.x)) return Trail(x.x, scaled(x.y), scaled(y.y))
    val times = DoubleArray(x.size + y.size)
    val ax = DoubleArray(times.size)
    val by = DoubleArray(times.size)
    var size = 0
    var i = 0
    var j = 0
    while (i < x.size || j < y.size) {
        val time = minOf(if (i < x.size) x.x[i] else Double.POSITIVE_INFINITY, if (j < y.size) y.x[j] else Double.POSITIVE_INFINITY)
        while (i < x.size && x.x[i] <= time) i++
        while (j < y.size && y.x[j] <= time) j++
        if (i == 0 || j == 0) continue
        times[size] = time
        ax[size] = x.y[i - 1] * scale
        by[size++] = y.y[j - 1] * scale
    }
    return Trail(times.copyOf(size), ax.copyOf(size), by.copyOf(size))
}
