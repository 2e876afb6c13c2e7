package badlog.core.analysis

/**
 * The range of some positions without a few outliers, which would make the others too small to see. An outlier is a hundred times as far
 * away as the others are from one another. At most one position in a hundred is an outlier. Positions that are not finite are ignored.
 *
 * @property range the range; null if there are no positions.
 * @property wildCount the number of outliers.
 * @property wildest the outlier that is farthest away; NaN if there are none.
 */
internal class UsualRange(positions: DoubleArray) {
    var range: ClosedFloatingPointRange<Double>? = null
        private set
    var wildCount: Int = 0
        private set
    var wildest: Double = Double.NaN
        private set

    init {
        val all = rangeOf(positions) { true }
        range = all
        if (all != null) {
            val bounds = boundsOf(positions)
            if (bounds != null && (all.start < bounds.start || all.endInclusive > bounds.endInclusive)) removeOutliers(positions, bounds)
        }
    }

    private fun removeOutliers(positions: DoubleArray, bounds: ClosedFloatingPointRange<Double>) {
        var count = 0
        var farthest = Double.NaN
        for (position in positions) {
            if (!position.isFinite() || position in bounds) continue
            count++
            if (!(distance(position, bounds) <= distance(farthest, bounds))) farthest = position
        }
        if (count > positions.size / POSITIONS_PER_OUTLIER) return
        wildCount = count
        wildest = farthest
        range = rangeOf(positions) { it in bounds }
    }

    private fun distance(position: Double, bounds: ClosedFloatingPointRange<Double>) =
        maxOf(bounds.start - position, position - bounds.endInclusive)

    /** Returns the bounds beyond which a position is an outlier; null if that cannot be decided. Uses a sample of the positions. */
    private fun boundsOf(positions: DoubleArray): ClosedFloatingPointRange<Double>? {
        val step = maxOf(1, positions.size / MAX_EXAMINED)
        val some = (positions.indices step step).map { positions[it] }.filter { it.isFinite() }.sorted()
        if (some.size < MIN_POSITIONS) return null
        val cut = some.size / POSITIONS_PER_IGNORED
        val from = some[cut]
        val to = some[some.lastIndex - cut]
        val reach = (to - from) * OUTLIER_DISTANCE
        return if (reach > 0 && reach.isFinite()) from - reach..to + reach else null
    }

    private inline fun rangeOf(positions: DoubleArray, isUsual: (Double) -> Boolean): ClosedFloatingPointRange<Double>? {
        var from = Double.POSITIVE_INFINITY
        var to = Double.NEGATIVE_INFINITY
        for (position in positions) {
            if (!position.isFinite() || !isUsual(position)) continue
            if (position < from) from = position
            if (position > to) to = position
        }
        return if (from <= to) from..to else null
    }
}

/** An outlier is this many times as far away as the others are from one another. */
private const val OUTLIER_DISTANCE = 100.0

/** At most one in this many positions may be an outlier. */
private const val POSITIONS_PER_OUTLIER = 100

/** One position in this many is ignored at each end when the spread of the others is measured. */
private const val POSITIONS_PER_IGNORED = 20

/** With fewer positions than this, no position counts as an outlier. */
private const val MIN_POSITIONS = 100
private const val MAX_EXAMINED = 2000
