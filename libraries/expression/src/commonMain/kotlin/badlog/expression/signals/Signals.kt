package badlog.expression.signals

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.expression.samples.Stretches

/** The named signals of one recording, as expressions see them. Implementations should cache their results, since they are called often. */
interface Signals {
    /** The names of the signals. */
    val vocabulary: Vocabulary

    /**
     * Returns the samples of the signal called [name], one of [vocabulary]: numbers, 0 and 1, or indices into [states].
     * NaN is a gap. Signals with the same times should share the same array of them, which makes combining them cheap.
     */
    fun series(name: String): Series

    /** Returns the texts that the samples of the state or event signal [name] stand for. */
    fun states(name: String): List<String>

    /** The times at which the robot was enabled, in the order of time. Null if the recording does not show them. */
    val enabled: List<EnabledSpan>?

    /** Whether [enabled] distinguishes autonomous and teleop. */
    val knowsAutonomous: Boolean get() = enabled != null

    /** The x axis as a signal: at each position, the sample is that position. */
    val axis: Series

    /** The x of each row, in the same array that the series of topics in rows have. Null if there are no rows. */
    val rows: DoubleArray?

    /** The range from the first sample of the recording to the last; null if there are none. */
    val range: Span?

    /** The unit of x; `ul` or empty for none. If the [vocabulary] has time, no unit means seconds. */
    val timeUnit: String

    /** The course of time if the clock of the rows was set back. Null if it never was, or if the samples alone show it. */
    val stretches: Stretches? get() = null
}
