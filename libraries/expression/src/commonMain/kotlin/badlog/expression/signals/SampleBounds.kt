package badlog.expression.signals

/** The bounds of [samples], each calculated on demand; NaN if there are none. */
class SampleBounds(private val samples: DoubleArray) {
    /** The smallest and the largest of some numbers, and whether some are not finite. */
    private class Bounds(val low: Double, val high: Double, val hasGaps: Boolean)

    private val own by lazy { bounds(0) { samples[it] } }
    private val steps by lazy { bounds(1) { samples[it] - samples[it - 1] } }

    /** The smallest sample. */
    val low: Double get() = own.low

    /** The largest sample. */
    val high: Double get() = own.high

    /** The smallest difference from one sample to the next. */
    val minStep: Double get() = steps.low

    /** The largest difference from one sample to the next. */
    val maxStep: Double get() = steps.high

    /** Whether some samples are not finite. */
    val hasGaps: Boolean get() = own.hasGaps

    private inline fun bounds(from: Int, value: (Int) -> Double): Bounds {
        var low = Double.POSITIVE_INFINITY
        var high = Double.NEGATIVE_INFINITY
        var numbers = 0
        for (i in from until samples.size) {
            val sample = value(i)
            if (sample < low) low = sample
            if (sample > high) high = sample
            if (!sample.isNaN()) numbers++
        }
        val size = maxOf(0, samples.size - from)
        if (numbers == 0) return Bounds(Double.NaN, Double.NaN, hasGaps = size > 0)
        return Bounds(low, high, hasGaps = numbers < size || !low.isFinite() || !high.isFinite())
    }
}
