package badlog.expression.signals

import badlog.analysis.EnabledSpan
import badlog.analysis.Series
import badlog.analysis.Span
import badlog.expression.samples.Stretches

/** The named signals of one recording, as expressions see them. An implementation keeps what it made: it is asked often. */
public interface Signals {
    /** What there is. */
    public val vocabulary: Vocabulary

    /**
     * The samples of the signal called [name], one of [vocabulary]: numbers, 0 and 1, or places in [states]. NaN is a gap.
     * Signals that share their times should share the very array of them, which makes combining them cheap.
     */
    public fun series(name: String): Series

    /** The texts that the samples of the state or event signal [name] stand for. */
    public fun states(name: String): List<String>

    /** When the robot was enabled, in the order of time; null where the recording does not tell. */
    public val enabled: List<EnabledSpan>?

    /** Whether [enabled] distinguishes autonomous and teleoperated. */
    public val knowsAutonomous: Boolean get() = enabled != null

    /** The x axis as a signal: a sample at each of its positions, which is that position. */
    public val axis: Series

    /** The x of each row of the recording, the very array that the series of topics in rows have; null where there are no rows. */
    public val rows: DoubleArray?

    /** From the first sample of the recording to the last, or null without any. */
    public val range: Span?

    /** The unit of x; `ul` or empty for none. Where the [vocabulary] has time, no unit means seconds. */
    public val timeUnit: String

    /** How time went where the clock of the rows was set back; null where it never was, or the samples alone tell it. */
    public val stretches: Stretches? get() = null
}
