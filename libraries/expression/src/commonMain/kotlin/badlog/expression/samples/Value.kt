package badlog.expression.samples

import badlog.core.analysis.Span

/** The result of a part of an expression. */
internal sealed interface Value

/**
 * One number for the whole recording, NaN if there is none; for a condition 1, 0 or NaN.
 *
 * @property time its time; NaN if it has none.
 * @property spans the spans of the condition that the number describes; null for none.
 */
internal class Scalar(val value: Double, val time: Double = Double.NaN, val spans: Spans? = null) : Value {
    /** Returns a scalar with the time as its number. */
    fun timeAlone(): Scalar = Scalar(time, time)
}

/**
 * Samples in the order of time. Each holds until the next one.
 *
 * @property x the times, ascending.
 * @property y numbers, conditions as 1 and 0, or indices into [texts]; NaN is a gap.
 * @property texts the texts that the samples stand for; null if they are numbers.
 * @property isMomentary whether each sample is over at once, like an event.
 * @property stretches the logged times of [x], if the clock was set back and [x] is on the continuous clock; otherwise null.
 */
internal class Column(
    val x: DoubleArray,
    val y: DoubleArray,
    val texts: List<String>? = null,
    val isMomentary: Boolean = false,
    val stretches: Stretches? = null,
) : Value {
    val size: Int get() = x.size

    /** Returns the logged time of sample [index]. */
    fun time(index: Int): Double = stretches?.logged(x[index]) ?: x[index]

    /** Returns the logged time of [position], one of x. */
    fun logged(position: Double): Double = stretches?.logged(position) ?: position

    /** Returns the time until which sample [index] holds: the next sample's time, or [end]. A moment is over at once. */
    fun until(index: Int, end: Double): Double = when {
        isMomentary -> x[index]
        index + 1 < x.size && x[index + 1] < end -> x[index + 1]
        else -> end
    }

    /** Returns the time for which sample [index] holds. */
    fun width(index: Int, end: Double): Double = maxOf(0.0, until(index, end) - x[index])

    /** Returns the end of the recording, as a value of [x]. The recording has the times [range]. */
    fun end(range: Span?): Double = when {
        // Topics with times of their own may extend beyond the rows.
        stretches != null -> if (x.isEmpty()) stretches.end else maxOf(stretches.end, x.last())

        else -> range?.to ?: Double.NEGATIVE_INFINITY
    }

    /** Returns a column of [samples] at the same times. */
    fun with(samples: DoubleArray): Column = Column(x, samples, null, isMomentary, stretches)

    /** Returns a column of [samples] of the same kind at the same times. */
    fun withAlike(samples: DoubleArray): Column = Column(x, samples, texts, isMomentary, stretches)
}
