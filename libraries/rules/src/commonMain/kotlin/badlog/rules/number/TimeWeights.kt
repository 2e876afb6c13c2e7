package badlog.rules.number

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.weightedPercentile

/** Returns the time within [spans] for each sample at [x]; [spans] ascend. A sample holds until the next, and the last one until [end]. */
internal fun timeWithin(spans: List<Span>, x: DoubleArray, end: Double): DoubleArray {
    val weights = DoubleArray(x.size)
    var first = 0
    for (i in x.indices) {
        val from = x[i]
        val until = if (i + 1 < x.size) x[i + 1] else end
        while (first < spans.size && spans[first].to <= from) first++
        var at = first
        while (at < spans.size && spans[at].from < until) {
            weights[i] += maxOf(0.0, minOf(until, spans[at].to) - maxOf(from, spans[at].from))
            at++
        }
    }
    return weights
}

/** Returns the mean of [series], weighted by [weights]; NaN if there are samples for less than [least] in total. */
internal fun meanOf(series: Series, weights: DoubleArray, least: Double): Double {
    var sum = 0.0
    var time = 0.0
    for (i in weights.indices) {
        val value = series.y[i]
        if (weights[i] <= 0 || !value.isFinite()) continue
        sum += weights[i] * value
        time += weights[i]
    }
    return if (time >= least && time > 0) sum / time else Double.NaN
}

/** Returns the weighted percentile of [series] at [share], a fraction from 0 to 1. NaN if the weights total less than [least]. */
internal fun percentileOf(series: Series, weights: DoubleArray, share: Double, least: Double): Double {
    val values = DoubleArray(weights.size)
    val counted = DoubleArray(weights.size)
    var size = 0
    var time = 0.0
    for (i in weights.indices) {
        if (weights[i] <= 0 || !series.y[i].isFinite()) continue
        values[size] = series.y[i]
        counted[size++] = weights[i]
        time += weights[i]
    }
    return if (time >= least) weightedPercentile(values, counted, size, share) else Double.NaN
}

/** Returns [spans] in order; those that touch, overlap, or are at most [gap] apart are joined. */
internal fun united(spans: List<Span>, gap: Double): List<Span> {
    val united = ArrayList<Span>()
    for (span in spans.sortedBy { it.from }) {
        val last = united.lastOrNull()
        if (last != null && span.from <= last.to + gap) {
            united[united.lastIndex] = Span(last.from, maxOf(last.to, span.to))
        } else {
            united += span
        }
    }
    return united
}

/** Returns the intersection of [one] and [other], both ascending. */
internal fun common(one: List<Span>, other: List<Span>): List<Span> {
    val found = ArrayList<Span>()
    var i = 0
    var k = 0
    while (i < one.size && k < other.size) {
        val from = maxOf(one[i].from, other[k].from)
        val to = minOf(one[i].to, other[k].to)
        if (from < to) found += Span(from, to)
        if (one[i].to < other[k].to) i++ else k++
    }
    return found
}
