package badlog.expression.samples

import badlog.analysis.Span
import badlog.analysis.TrapezoidSum
import badlog.analysis.select
import kotlin.math.sqrt

// Whole recordings in one figure. Samples without a finite value do not count, and without any other there is no figure.

internal fun Column.minimum(): Scalar {
    var place = -1
    for (i in 0 until size) if (y[i].isFinite() && (place < 0 || y[i] < y[place])) place = i
    return at(place)
}

internal fun Column.maximum(): Scalar {
    var place = -1
    for (i in 0 until size) if (y[i].isFinite() && (place < 0 || y[i] > y[place])) place = i
    return at(place)
}

internal fun Column.first(): Scalar = at(y.indexOfFirst { it.isFinite() })

internal fun Column.last(): Scalar = at(y.indexOfLast { it.isFinite() })

private fun Column.at(place: Int) = if (place < 0) Scalar(Double.NaN) else Scalar(y[place], time(place))

internal fun Column.mean(): Scalar = Scalar(moments { mean, _, count -> if (count > 0) mean else Double.NaN })

/** Of a sample, dividing by one less than the count. */
internal fun Column.standardDeviation(): Scalar =
    Scalar(moments { _, squares, count -> if (count > 1) sqrt(squares / (count - 1)) else Double.NaN })

// Welford's recurrence (1962).
private inline fun Column.moments(result: (Double, Double, Int) -> Double): Double {
    var count = 0
    var mean = 0.0
    var squares = 0.0
    for (value in y) {
        if (!value.isFinite()) continue
        val distance = value - mean
        mean += distance / ++count
        squares += distance * (value - mean)
    }
    return result(mean, squares, count)
}

/** The value below which [percent] % lie, interpolated between neighbors as in [badlog.analysis.SeriesStatistics]. */
internal fun Column.percentile(percent: Double): Scalar {
    val values = DoubleArray(size)
    var count = 0
    for (value in y) if (value.isFinite()) values[count++] = value
    if (count == 0) return Scalar(Double.NaN)
    val place = percent / 100 * (count - 1)
    val below = place.toInt()
    select(values, below, 0, count)
    if (below == count - 1) return Scalar(values[below])
    var above = values[below + 1]
    for (i in below + 2 until count) if (values[i] < above) above = values[i]
    return Scalar(values[below] + (above - values[below]) * (place - below))
}

/** By the trapezoid rule, gaps left out. */
internal fun Column.wholeIntegral(): Scalar {
    val sum = TrapezoidSum()
    for (i in 0 until size) sum.add(x[i], y[i])
    return Scalar(if (y.any { it.isFinite() }) sum.value else Double.NaN)
}

/** From the first sample with a value to the last. */
internal fun Column.duration(): Scalar {
    val first = y.indexOfFirst { it.isFinite() }
    return Scalar(if (first < 0) Double.NaN else x[y.indexOfLast { it.isFinite() }] - x[first])
}

/** How often a condition becomes true, else how many samples have a value. */
internal fun Column.count(isCondition: Boolean, range: Span?): Scalar {
    if (isCondition) return spans(end(range)).let { Scalar(it.times.toDouble(), it.firstTime(), it) }
    return Scalar(y.count { it.isFinite() }.toDouble())
}

/** Whether the condition ever holds; not known where it is never known, but where there are no events, none holds. */
internal fun Column.any(range: Span?): Scalar {
    val spans = spans(end(range))
    val isKnown = isMomentary || y.any { it == 0.0 }
    return Scalar(
        if (spans.isNotEmpty()) {
            1.0
        } else if (isKnown) {
            0.0
        } else {
            Double.NaN
        },
        spans.firstTime(),
        spans,
    )
}

/** Whether the condition holds wherever it is known; not known where it is never known. */
internal fun Column.all(): Scalar {
    val failing = y.indexOfFirst { it == 0.0 }
    return if (failing >= 0) Scalar(0.0, time(failing)) else Scalar(if (y.any { it == 1.0 }) 1.0 else Double.NaN)
}

/** How long the condition holds. */
internal fun Column.total(range: Span?): Scalar = spans(end(range)).let { Scalar(it.total, it.firstTime(), it) }

private fun Spans.firstTime() = if (isEmpty()) Double.NaN else this[0].from
