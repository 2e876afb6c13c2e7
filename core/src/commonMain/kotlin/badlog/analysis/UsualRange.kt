package badlog.analysis

/**
 * From where to where the finite ones of some positions lie, without a few that lie so far from all others that nothing of these could be
 * seen any more: a hundred times as far as they lie from one another, and no more than one of a hundred.
 *
 * @property range it; null without any position.
 * @property wildCount how many positions are left out.
 * @property wildest the one of those farthest away; NaN without any.
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
            if (bounds != null && (all.start < bounds.start || all.endInclusive > bounds.endInclusive)) leaveOut(positions, bounds)
        }
    }

    private fun leaveOut(positions: DoubleArray, bounds: ClosedFloatingPointRange<Double>) {
        var count = 0
        var farthest = Double.NaN
        for (position in positions) {
            if (!position.isFinite() || position in bounds) continue
            count++
            if (!(distance(position, bounds) <= distance(farthest, bounds))) farthest = position
        }
        if (count > positions.size / FEW) return
        wildCount = count
        wildest = farthest
        range = rangeOf(positions) { it in bounds }
    }

    private fun distance(position: Double, bounds: ClosedFloatingPointRange<Double>) =
        maxOf(bounds.start - position, position - bounds.endInclusive)

    /** Beyond what a position is wild; null where that cannot be told. Looks at some positions of the whole log. */
    private fun boundsOf(positions: DoubleArray): ClosedFloatingPointRange<Double>? {
        val step = maxOf(1, positions.size / LOOKED_AT)
        val some = (positions.indices step step).map { positions[it] }.filter { it.isFinite() }.sorted()
        if (some.size < FEWEST) return null
        val cut = some.size / PART
        val from = some[cut]
        val to = some[some.lastIndex - cut]
        val reach = (to - from) * FAR
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

    private companion object {
        /** So many times as far away as the others lie from one another is wild. */
        const val FAR = 100.0

        /** One of so many positions may be wild. */
        const val FEW = 100

        /** One of so many is not counted at either end when it is asked how far the others lie from one another. */
        const val PART = 20

        /** Fewer positions than these have no usual range. */
        const val FEWEST = 100
        const val LOOKED_AT = 2000
    }
}
