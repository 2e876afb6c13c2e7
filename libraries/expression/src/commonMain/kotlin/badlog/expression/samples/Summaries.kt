package badlog.expression.samples

import badlog.analysis.AreaSum
import badlog.analysis.Moments
import badlog.analysis.Span
import badlog.analysis.select
import badlog.analysis.weightedPercentile

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

/** The last value, at the time until which it holds. */
internal fun Column.last(range: Span?): Scalar {
    val place = y.indexOfLast { it.isFinite() }
    return if (place < 0) at(place) else Scalar(y[place], logged(until(place, end(range))))
}

private fun Column.at(place: Int) = if (place < 0) Scalar(Double.NaN) else Scalar(y[place], time(place))

/** Weighed by time; moments weigh the same. */
internal fun Column.mean(range: Span?): Scalar = Scalar(momentsByTime(range).mean)

/** Weighed by time; moments weigh the same. */
internal fun Column.standardDeviation(range: Span?): Scalar = Scalar(momentsByTime(range).standardDeviation)

internal fun Column.sampleMean(): Scalar = Scalar(momentsOfSamples().mean)

/** Of a sample, dividing by one less than the count. */
internal fun Column.sampleStandardDeviation(): Scalar = Scalar(momentsOfSamples().sampleStandardDeviation)

private fun Column.momentsByTime(range: Span?): Moments {
    val end = end(range)
    val moments = Moments()
    for (i in 0 until size) {
        if (!y[i].isFinite()) continue
        val weight = width(i, end)
        if (weight > 0) moments.add(y[i], weight)
    }
    // Where nothing holds for any time, the samples are all there is.
    return if (moments.mean.isNaN()) momentsOfSamples() else moments
}

private fun Column.momentsOfSamples(): Moments {
    val moments = Moments()
    for (value in y) if (value.isFinite()) moments.add(value, 1.0)
    return moments
}

/** The value below which it lies for [percent] % of the time, see [weightedPercentile]; moments weigh the same. */
internal fun Column.percentile(percent: Double, range: Span?): Scalar {
    val end = end(range)
    val values = DoubleArray(size)
    val weights = DoubleArray(size)
    var count = 0
    for (i in 0 until size) {
        if (!y[i].isFinite()) continue
        val weight = width(i, end)
        if (weight <= 0) continue
        values[count] = y[i]
        weights[count++] = weight
    }
    if (count == 0) {
        for (value in y) if (value.isFinite()) values[count++] = value
        weights.fill(1.0)
    }
    return Scalar(weightedPercentile(values, weights, count, percent / 100))
}

/** The value below which [percent] % of the samples lie, interpolated linearly between neighbours (type 7 of Hyndman and Fan). */
internal fun Column.samplePercentile(percent: Double): Scalar {
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

/** The area under the values, each as long as it holds; gaps have none. */
internal fun Column.wholeIntegral(range: Span?): Scalar {
    val sum = AreaSum()
    var isKnown = false
    val end = end(range)
    for (i in 0 until size) {
        if (x[i] > end) break
        sum.add(x[i], y[i])
        if (y[i].isFinite()) isKnown = true
    }
    sum.holdUntil(end)
    return Scalar(if (isKnown) sum.value else Double.NaN)
}

/** From the first sample with a value until the last value holds no more. */
internal fun Column.duration(range: Span?): Scalar {
    val first = y.indexOfFirst { it.isFinite() }
    if (first < 0) return Scalar(Double.NaN)
    val last = y.indexOfLast { it.isFinite() }
    return Scalar(maxOf(0.0, until(last, end(range)) - x[first]))
}

/** How often a condition becomes true, else how many samples have a value. */
internal fun Column.count(isCondition: Boolean, range: Span?): Scalar {
    if (isCondition) return spans(end(range)).let { ifKnown(it, it.times.toDouble()) }
    return Scalar(y.count { it.isFinite() }.toDouble())
}

/** How long the condition holds. */
internal fun Column.total(range: Span?): Scalar = spans(end(range)).let { ifKnown(it, it.total) }

/** [figure] of [spans]; none where it is never known whether the condition holds. Where there are no events, none holds. */
private fun Column.ifKnown(spans: Spans, figure: Double) =
    Scalar(if (isMomentary || y.any { !it.isNaN() }) figure else Double.NaN, spans.firstTime(), spans)

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

private fun Spans.firstTime() = if (isEmpty()) Double.NaN else this[0].from
