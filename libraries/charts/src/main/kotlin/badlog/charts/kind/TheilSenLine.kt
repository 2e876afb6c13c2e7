package badlog.charts.kind

/**
 * The Theil–Sen line through points: its slope is the median of the slopes between all pairs. A few outliers, which the chart has to show,
 * do not tilt it.
 */
internal class TheilSenLine(val slope: Double, private val intercept: Double) {
    /** Returns its y at [x]. */
    fun at(x: Double): Double = intercept + slope * x

    /** Returns the part of [x] where the line is within [y]; null if there is none. */
    fun within(x: ClosedFloatingPointRange<Double>, y: ClosedFloatingPointRange<Double>): Pair<Double, Double>? {
        val ends = if (slope == 0.0) null else listOf((y.start - intercept) / slope, (y.endInclusive - intercept) / slope).sorted()
        val from = maxOf(x.start, ends?.first() ?: x.start)
        val to = minOf(x.endInclusive, ends?.last() ?: x.endInclusive)
        return (from to to).takeIf { from < to }
    }

    companion object {
        /**
         * Returns the line through the points at [x] and [y]; null if all have the same x.
         *
         * @throws InterruptedException if the thread was interrupted.
         */
        fun through(x: List<Double>, y: List<Double>): TheilSenLine? {
            // There are as many slopes as pairs, and more points would not give another line.
            val count = minOf(x.size, MAX_POINTS)
            val chosen = IntArray(count) { (it.toLong() * x.size / count).toInt() }
            val slopes = DoubleArray(count * (count - 1) / 2)
            var known = 0
            for (i in chosen.indices) {
                if (Thread.interrupted()) throw InterruptedException()
                for (k in 0 until i) {
                    val across = x[chosen[i]] - x[chosen[k]]
                    if (across != 0.0) slopes[known++] = (y[chosen[i]] - y[chosen[k]]) / across
                }
            }
            if (known == 0) return null
            slopes.sort(0, known)
            val slope = (slopes[(known - 1) / 2] + slopes[known / 2]) / 2
            return TheilSenLine(slope, Quartiles.of(x.indices.map { y[it] - slope * x[it] }).median)
        }

        /** The number of points with half a million pairs. */
        private const val MAX_POINTS = 1000
    }
}
