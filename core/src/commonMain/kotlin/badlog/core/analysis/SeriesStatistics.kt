package badlog.core.analysis

import kotlin.math.sqrt

/**
 * Statistics of a series over a range of x. Each sample holds until the next. Mean, standard deviation and percentiles are weighted by x,
 * so they are the same for a value logged repeatedly or only when it changed. Gaps have no weight. Everything but the counts is NaN if
 * there is no value in the range.
 *
 * @property count the number of samples in the range that have a finite value.
 * @property gaps the number of samples in the range that have none.
 * @property min the smallest value, including one that still holds from before the range.
 * @property max the largest value, including one that still holds from before the range.
 * @property mean the mean, with each value weighted by how long it holds.
 * @property standardDeviation the root mean square of the distances from [mean], weighted likewise.
 * @property percentile5 the value below which the series lies for 5 % of the time; see [weightedPercentile].
 * @property median the same for 50 %.
 * @property percentile95 the same for 95 %.
 * @property first the first finite value.
 * @property last the last finite value.
 * @property integral the area under the values, each for as long as it holds.
 */
public data class SeriesStatistics(
    public val count: Int,
    public val gaps: Int,
    public val min: Double,
    public val max: Double,
    public val mean: Double,
    public val standardDeviation: Double,
    public val percentile5: Double,
    public val median: Double,
    public val percentile95: Double,
    public val first: Double,
    public val last: Double,
    public val integral: Double,
)

/**
 * Returns the statistics from [from] to [to], both ends included. The value that still holds at [from] counts, too. In an ordered series
 * only these samples are visited; two arrays are allocated for them.
 *
 * @param end the x until which the last sample holds, such as the end of its recording; NaN if it ends at its own x.
 */
public fun Series.statistics(
    from: Double = Double.NEGATIVE_INFINITY,
    to: Double = Double.POSITIVE_INFINITY,
    end: Double = Double.NaN,
): SeriesStatistics = statistics(listOf(Span(from, to)), end)

/**
 * Returns the statistics of several [parts] together, leaving out everything between them. An example is the time in which a robot was
 * enabled.
 *
 * @param parts in the order of x; they do not touch.
 * @param end see the statistics of a single part.
 */
public fun Series.statistics(parts: List<Span>, end: Double = Double.NaN): SeriesStatistics {
    val pieces = parts.map { Piece(this, it) }
    val weighted = WeightedValues(pieces.sumOf { maxOf(0, it.stop - it.held) })
    val isOrdered = isOrdered
    for (piece in pieces) {
        val (from, to) = piece.part
        for (i in piece.held until piece.stop) {
            if (i >= piece.begin && x[i] !in from..to) continue
            val until = when {
                i + 1 == size -> if (end > x[i]) end else x[i]
                isOrdered || x[i + 1] in from..to -> x[i + 1]
                else -> x[i]
            }
            weighted.add(maxOf(x[i], from), minOf(until, to), y[i], isCounted = i >= piece.begin)
        }
    }
    return weighted.statistics()
}

/** The samples of [series] within [part]. */
private class Piece(series: Series, val part: Span) {
    val begin = if (series.isOrdered) series.firstAtOrAfter(part.from) else 0
    val stop = if (series.isOrdered) series.firstAfter(part.to) else series.size

    private val hasEarlier = series.isOrdered && part.from <= part.to && begin in 1..series.size
    private val beginsWithSample = begin < series.size && series.x[begin] == part.from

    /** A value still holds from before the part, unless there is a sample exactly at its start. */
    val held = if (hasEarlier && !beginsWithSample) begin - 1 else begin
}

/** Returns the statistics of this line from [from] to [to]. If its values hold, the last one holds until the end of its recording. */
public fun GraphSeries.statistics(from: Double = Double.NEGATIVE_INFINITY, to: Double = Double.POSITIVE_INFINITY): SeriesStatistics =
    statistics(listOf(Span(from, to)))

/** Returns the statistics of several [parts] together, which are in the order of x and do not touch. */
public fun GraphSeries.statistics(parts: List<Span>): SeriesStatistics =
    data.statistics(parts, recorded?.endInclusive?.takeIf { holds } ?: Double.NaN)

private class WeightedValues(most: Int) {
    private val values = DoubleArray(most)
    private val weights = DoubleArray(most)
    private var size = 0
    private var count = 0
    private var gaps = 0
    private var min = Double.NaN
    private var max = Double.NaN
    private var first = Double.NaN
    private var last = Double.NaN
    private val area = AreaSum()

    fun add(from: Double, until: Double, value: Double, isCounted: Boolean) {
        area.add(from, value)
        area.holdUntil(until)
        if (!value.isFinite()) {
            if (isCounted) gaps++
            return
        }
        if (isCounted) count++
        if (first.isNaN()) first = value
        last = value
        min = if (min.isNaN()) value else minOf(min, value)
        max = if (max.isNaN()) value else maxOf(max, value)
        values[size] = value
        weights[size++] = maxOf(0.0, until - from)
    }

    fun statistics(): SeriesStatistics {
        dropWeightless()
        val (mean, standardDeviation) = moments()
        val percentiles = WeightedPercentiles(values, weights, size)
        return SeriesStatistics(
            count = count,
            gaps = gaps,
            min = min,
            max = max,
            mean = mean,
            standardDeviation = standardDeviation,
            percentile5 = percentiles.of(LOW),
            median = percentiles.of(MEDIAN),
            percentile95 = percentiles.of(HIGH),
            first = first,
            last = last,
            integral = if (first.isNaN()) Double.NaN else area.value,
        )
    }

    /**
     * Returns the weighted mean and standard deviation. The second pass corrects the rounding error in the first pass's mean. So both stay
     * accurate if all values are far from 0, or if one is far from the others.
     */
    private fun moments(): Pair<Double, Double> {
        var weight = 0.0
        var sum = 0.0
        for (i in 0 until size) {
            weight += weights[i]
            sum += weights[i] * (values[i] - values[0])
        }
        val near = if (size == 0) Double.NaN else values[0] + sum / weight
        var squares = 0.0
        var error = 0.0
        for (i in 0 until size) {
            val distance = values[i] - near
            squares += weights[i] * distance * distance
            error += weights[i] * distance
        }
        return near + error / weight to sqrt(maxOf(0.0, squares - error * error / weight) / weight)
    }

    /** Drops values that hold for no time; if none holds for any time, all have the same weight. */
    private fun dropWeightless() {
        var kept = 0
        for (i in 0 until size) {
            if (weights[i] <= 0) continue
            values[kept] = values[i]
            weights[kept++] = weights[i]
        }
        if (kept > 0) size = kept else weights.fill(1.0)
    }
}

/** Mean and standard deviation of weighted values, by West's recurrence (1979), which avoids the cancellation of sums of squares. */
public class Moments {
    private var weight = 0.0
    private var center = 0.0
    private var squares = 0.0

    /** Adds [value], which is finite, with [weight] above 0. */
    public fun add(value: Double, weight: Double) {
        this.weight += weight
        val distance = value - center
        center += distance * (weight / this.weight)
        squares += weight * distance * (value - center)
    }

    /** The mean; NaN if there are no values. */
    public val mean: Double get() = if (weight > 0) center else Double.NaN

    /** The root mean square of the distances from [mean]; NaN if there are no values. */
    public val standardDeviation: Double get() = if (weight > 0) sqrt(squares / weight) else Double.NaN

    /**
     * The sample standard deviation, with the number of values minus one as its divisor. All weights must be 1; NaN for fewer than two
     * values.
     */
    public val sampleStandardDeviation: Double get() = if (weight > 1) sqrt(squares / (weight - 1)) else Double.NaN
}

private const val LOW = 0.05
private const val MEDIAN = 0.5
private const val HIGH = 0.95
