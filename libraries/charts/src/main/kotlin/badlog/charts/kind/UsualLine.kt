package badlog.charts.kind

/**
 * The line that most points are near: Theil and Sen’s, the median of the slopes between all pairs. A few points far away, which are those that
 * a chart is to show, do not turn it.
 */
internal class UsualLine(val slope: Double, private val intercept: Double) {
    /** Returns its height at [x]. */
    fun at(x: Double): Double = intercept + slope * x

    /** Returns the part of [x] in which it is within [y]; null if it is nowhere. */
    fun within(x: ClosedFloatingPointRange<Double>, y: ClosedFloatingPointRange<Double>): Pair<Double, Double>? {
        val ends = if (slope == 0.0) null else listOf((y.start - intercept) / slope, (y.endInclusive - intercept) / slope).sorted()
        val from = maxOf(x.start, ends?.first() ?: x.start)
        val to = minOf(x.endInclusive, ends?.last() ?: x.endInclusive)
        return (from to to).takeIf { from < to }
    }

    companion object {
        /** Returns the line through the points at [x] and [y]; null if all have the same x. */
        fun through(x: List<Double>, y: List<Double>): UsualLine? {
            val slopes = ArrayList<Double>()
            for (i in x.indices) for (k in 0 until i) if (x[i] != x[k]) slopes += (y[i] - y[k]) / (x[i] - x[k])
            if (slopes.isEmpty()) return null
            val slope = Quartiles.of(slopes).median
            return UsualLine(slope, Quartiles.of(x.indices.map { y[it] - slope * x[it] }).median)
        }
    }
}
