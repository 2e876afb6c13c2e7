package badlog.expression.samples

import badlog.core.analysis.AreaSum
import badlog.core.analysis.Moments
import badlog.core.analysis.Span
import badlog.core.analysis.select
import badlog.core.analysis.weightedPercentile

// Functions that reduce a whole recording to one number. Samples without a finite value are ignored; without any other sample, the result
// has no number.

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

/** Returns the last value. Its time is the time until which that value holds. */
internal fun Column.last(range: Span?): Scalar {
    val place = y.indexOfLast { it.isFinite() }
    return if (place < 0) at(place) else Scalar(y[place], logged(until(place, end(range))))
}

private fun Column.at(place: Int) = if (place < 0) Scalar(Double.NaN) else Scalar(y[place], time(place))

/** Returns the mean weighted by time; moments have equal weights. */
internal fun Column.mean(range: Span?): Scalar = Scalar(momentsByTime(range).mean)

/** Returns the standard deviation weighted by time; moments have equal weights. */
internal fun Column.standardDeviation(range: Span?): Scalar = Scalar(momentsByTime(range).standardDeviation)

internal fun Column.sampleMean(): Scalar = Scalar(momentsOfSamples().mean)

/** Returns the sample standard deviation, with the count minus one as its divisor. */
internal fun Column.sampleStandardDeviation(): Scalar = Scalar(momentsOfSamples().sampleStandardDeviation)

private fun Column.momentsByTime(range: Span?): Moments {
    val end = end(range)
    val moments = Moments()
    for (i in 0 until size) {
        if (!y[i].isFinite()) continue
        val weight = width(i, end)
        if (weight > 0) moments.add(y[i], weight)
    }
    // If nothing holds for any time, the samples themselves are used.
    return if (moments.mean.isNaN()) momentsOfSamples() else moments
}

private fun Column.momentsOfSamples(): Moments {
    val moments = Moments()
    for (value in y) if (value.isFinite()) moments.add(value, 1.0)
    return moments
}

/** Returns the value that the samples stay below for [percent] % of the time, see [weightedPercentile]; moments have equal weights. */
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

/**
 * Returns the value below which [percent] % of the samples lie. It is interpolated linearly between neighbors (type 7 of Hyndman and Fan).
 */
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

/** Returns the area under the values, each for as long as it holds; gaps have none. */
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

/** Returns the time from the first sample with a value to the end of the last value. */
internal fun Column.duration(range: Span?): Scalar {
    val first = y.indexOfFirst { it.isFinite() }
    if (first < 0) return Scalar(Double.NaN)
    val last = y.indexOfLast { it.isFinite() }
    return Scalar(maxOf(0.0, until(last, end(range)) - x[first]))
}

/** Returns the number of times that a condition becomes true, or, for numbers, the number of samples with a value. */
internal fun Column.count(isCondition: Boolean, range: Span?): Scalar {
    if (isCondition) return spans(end(range)).let { ifKnown(it, it.times.toDouble()) }
    return Scalar(y.count { it.isFinite() }.toDouble())
}

/** Returns the total time for which the condition holds. */
internal fun Column.total(range: Span?): Scalar = spans(end(range)).let { ifKnown(it, it.total) }

/** Returns [figure] for [spans]; unknown if the condition is never known. If there are no events, none holds. */
private fun Column.ifKnown(spans: Spans, figure: Double) =
    Scalar(if (isMomentary || y.any { !it.isNaN() }) figure else Double.NaN, spans.firstTime(), spans)

/** Returns whether the condition ever holds; unknown if it is never known. A condition of events without any event does not hold. */
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

/** Returns whether the condition holds wherever it is known; unknown if it is never known. */
internal fun Column.all(): Scalar {
    val failing = y.indexOfFirst { it == 0.0 }
    return if (failing >= 0) Scalar(0.0, time(failing)) else Scalar(if (y.any { it == 1.0 }) 1.0 else Double.NaN)
}

private fun Spans.firstTime() = if (isEmpty()) Double.NaN else this[0].from
