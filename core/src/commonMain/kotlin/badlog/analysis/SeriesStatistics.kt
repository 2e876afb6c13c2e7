package badlog.analysis

import kotlin.math.sqrt

/**
 * What a series does over a range of x. Each sample holds until the next: mean, standard deviation and percentiles weigh by x, so
 * that they are the same whether a value was logged again and again or only when it changed. Gaps weigh nothing. Every figure but
 * the counts is NaN when there is no value in the range.
 *
 * @property count how many samples of the range have a finite value.
 * @property gaps how many have none.
 * @property min the smallest value, be it one that only holds on from before the range.
 * @property max the largest value, likewise.
 * @property mean the mean, each value weighed by how long it holds.
 * @property standardDeviation the distance from [mean], in the root mean square, weighed likewise.
 * @property percentile5 the value below which it lies for 5 % of the time; see [weightedPercentile].
 * @property median the same for 50 %.
 * @property percentile95 the same for 95 %.
 * @property first the first finite value.
 * @property last the last finite value.
 * @property integral the area under the values, each as long as it holds.
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
 * The statistics from [from] to [to]: of the samples there, both ends included, and of the value that still holds at [from]. In a
 * series that is ordered it looks at those alone; it allocates two arrays for them.
 *
 * @param end until where the last sample holds, as until the end of its recording; NaN for no farther than where it stands.
 */
public fun Series.statistics(
    from: Double = Double.NEGATIVE_INFINITY,
    to: Double = Double.POSITIVE_INFINITY,
    end: Double = Double.NaN,
): SeriesStatistics = statistics(listOf(Span(from, to)), end)

/**
 * The statistics of several [parts] together, without what lies between them, as of the time in which a robot was enabled.
 *
 * @param parts in the order of x; they do not touch.
 * @param end as that of the statistics of one part.
 */
public fun Series.statistics(parts: List<Span>, end: Double = Double.NaN): SeriesStatistics {
    val pieces = parts.map { Piece(this, it) }
    val figures = WeighedFigures(pieces.sumOf { maxOf(0, it.stop - it.held) })
    for (piece in pieces) {
        val (from, to) = piece.part
        for (i in piece.held until piece.stop) {
            if (i >= piece.begin && x[i] !in from..to) continue
            val until = when {
                i + 1 == size -> if (end > x[i]) end else x[i]
                isOrdered || x[i + 1] in from..to -> x[i + 1]
                else -> x[i]
            }
            figures.add(maxOf(x[i], from), minOf(until, to), y[i], isCounted = i >= piece.begin)
        }
    }
    return figures.statistics()
}

/** The samples of [series] that [part] is about. */
private class Piece(series: Series, val part: Span) {
    val begin = if (series.isOrdered) series.firstAtOrAfter(part.from) else 0
    val stop = if (series.isOrdered) series.firstAfter(part.to) else series.size

    /** What holds on from before the part, unless a sample stands at its very begin. */
    val held = if (series.isOrdered && part.from <= part.to && begin in 1..series.size &&
        !(begin < series.size && series.x[begin] == part.from)
    ) {
        begin - 1
    } else {
        begin
    }
}

/** The statistics of [line], one of this view's; where its values hold, the last one does until the end of the recording. */
public fun LogView.statisticsOf(
    line: GraphSeries,
    from: Double = Double.NEGATIVE_INFINITY,
    to: Double = Double.POSITIVE_INFINITY,
): SeriesStatistics = statisticsOf(line, listOf(Span(from, to)))

/** The same of several [parts] together, which are in the order of x and do not touch. */
public fun LogView.statisticsOf(line: GraphSeries, parts: List<Span>): SeriesStatistics =
    line.data.statistics(parts, xAxis.range?.endInclusive?.takeIf { line.holds } ?: Double.NaN)

private class WeighedFigures(most: Int) {
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
        keepWeighty()
        val moments = Moments()
        for (i in 0 until size) moments.add(values[i], weights[i])
        return SeriesStatistics(
            count = count,
            gaps = gaps,
            min = min,
            max = max,
            mean = moments.mean,
            standardDeviation = moments.standardDeviation,
            percentile5 = weightedPercentile(values, weights, size, LOW),
            median = weightedPercentile(values, weights, size, MEDIAN),
            percentile95 = weightedPercentile(values, weights, size, HIGH),
            first = first,
            last = last,
            integral = if (first.isNaN()) Double.NaN else area.value,
        )
    }

    /** Leaves out what holds for no time; where nothing holds for any, each sample weighs the same. */
    private fun keepWeighty() {
        var kept = 0
        for (i in 0 until size) {
            if (weights[i] <= 0) continue
            values[kept] = values[i]
            weights[kept++] = weights[i]
        }
        if (kept > 0) size = kept else weights.fill(1.0)
    }

    private companion object {
        const val LOW = 0.05
        const val MEDIAN = 0.5
        const val HIGH = 0.95
    }
}

/** Mean and standard deviation of values that weigh differently, by West's recurrence (1979), without the cancellation of sums of squares. */
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

    /** The mean; NaN without values. */
    public val mean: Double get() = if (weight > 0) center else Double.NaN

    /** The root mean square of the distances from [mean]; NaN without values. */
    public val standardDeviation: Double get() = if (weight > 0) sqrt(squares / weight) else Double.NaN

    /** That of a sample of equal weights 1, dividing by one less than their number; NaN for fewer than two. */
    public val sampleStandardDeviation: Double get() = if (weight > 1) sqrt(squares / (weight - 1)) else Double.NaN
}
