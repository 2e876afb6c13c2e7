package badlog.expression.signals

/** Between what [samples] are, each found when it is asked for; NaN of nothing. */
public class SampleBounds(private val samples: DoubleArray) {
    private val finite by lazy { bounds(0) { samples[it] } }
    private val steps by lazy { bounds(1) { samples[it] - samples[it - 1] } }

    /** The smallest. */
    public val low: Double get() = finite.first

    /** The largest. */
    public val high: Double get() = finite.second

    /** The smallest difference from one to the next. */
    public val minStep: Double get() = steps.first

    /** The largest difference from one to the next. */
    public val maxStep: Double get() = steps.second

    /** Whether some are not finite. */
    public val hasGaps: Boolean by lazy { samples.any { !it.isFinite() } }

    private inline fun bounds(from: Int, value: (Int) -> Double): Pair<Double, Double> {
        var low = Double.NaN
        var high = Double.NaN
        for (i in from until samples.size) {
            val sample = value(i)
            if (!(sample >= low)) low = if (sample.isNaN()) low else sample
            if (!(sample <= high)) high = if (sample.isNaN()) high else sample
        }
        return low to high
    }
}
