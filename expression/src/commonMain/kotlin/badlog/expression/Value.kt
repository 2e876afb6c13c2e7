package badlog.expression

/** What a part of an expression came to. */
internal sealed interface Value

/**
 * One number for the whole recording, NaN where there is none; for a condition 1, 0 or NaN.
 *
 * @property time where it was found, NaN where it has no place of its own.
 * @property spans when the condition held that it speaks of, or null.
 */
internal class Scalar(val value: Double, val time: Double = Double.NaN, val spans: Spans? = null) : Value {
    /** The time as the value. */
    fun timeAlone(): Scalar = Scalar(time, time)
}

/**
 * Samples in the order of time. Each stays until the next one.
 *
 * @property x the times.
 * @property y numbers, conditions as 1 and 0, or places in [texts]; NaN is a gap.
 * @property texts what the samples stand for, or null where they are numbers.
 * @property isMomentary whether each sample is over at once, as events are.
 */
internal class Column(
    val x: DoubleArray,
    val y: DoubleArray,
    val texts: List<String>? = null,
    val isMomentary: Boolean = false,
) : Value {
    val size: Int get() = x.size

    /** Other samples at the same times. */
    fun with(samples: DoubleArray): Column = Column(x, samples, null, isMomentary)

    /** Samples of the same sort, at the same times. */
    fun withAlike(samples: DoubleArray): Column = Column(x, samples, texts, isMomentary)
}
