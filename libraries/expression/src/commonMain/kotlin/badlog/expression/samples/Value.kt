package badlog.expression.samples

import badlog.analysis.Span

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
 * @property x the times, ascending.
 * @property y numbers, conditions as 1 and 0, or places in [texts]; NaN is a gap.
 * @property texts what the samples stand for, or null where they are numbers.
 * @property isMomentary whether each sample is over at once, as events are.
 * @property stretches how [x], which goes on where the clock was set back, was logged; null where it is as logged.
 */
internal class Column(
    val x: DoubleArray,
    val y: DoubleArray,
    val texts: List<String>? = null,
    val isMomentary: Boolean = false,
    val stretches: Stretches? = null,
) : Value {
    val size: Int get() = x.size

    /** When sample [index] was taken, as it was logged. */
    fun time(index: Int): Double = stretches?.logged(x[index]) ?: x[index]

    /** When [position], one of x, was logged. */
    fun logged(position: Double): Double = stretches?.logged(position) ?: position

    /** Until when sample [index] holds: until the next one, or [end]. A moment is over at once. */
    fun until(index: Int, end: Double): Double = when {
        isMomentary -> x[index]
        index + 1 < x.size && x[index + 1] < end -> x[index + 1]
        else -> end
    }

    /** How long sample [index] holds. */
    fun width(index: Int, end: Double): Double = maxOf(0.0, until(index, end) - x[index])

    /** The end of the recording with the times [range], in terms of [x]. */
    fun end(range: Span?): Double = when {
        // Topics with times of their own may go on beyond the rows.
        stretches != null -> if (x.isEmpty()) stretches.end else maxOf(stretches.end, x.last())

        else -> range?.to ?: Double.NEGATIVE_INFINITY
    }

    /** Other samples at the same times. */
    fun with(samples: DoubleArray): Column = Column(x, samples, null, isMomentary, stretches)

    /** Samples of the same sort, at the same times. */
    fun withAlike(samples: DoubleArray): Column = Column(x, samples, texts, isMomentary, stretches)
}
