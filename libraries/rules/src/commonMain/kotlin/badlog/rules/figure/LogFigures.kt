package badlog.rules.figure

/**
 * What is measured, and of what.
 *
 * @property signal what the topic means, or [RESISTANCE].
 * @property topic its full name.
 * @property unit the unit of the figure, empty for none.
 */
public data class FigureKey(public val signal: String, public val topic: String, public val measure: Measure, public val unit: String) {
    public companion object {
        /** The signal of the figure that battery and total current have together. */
        public const val RESISTANCE: String = "battery resistance"
    }
}

/** What a log is of: logs of one kind are compared. */
public enum class MatchKind(internal val words: String) {
    /** A match that counts. */
    MATCH("matches"),

    /** Practice, or a test. */
    PRACTICE("practice runs"),

    /** The log does not say. */
    UNKNOWN("logs"),
}

/**
 * Numbers that say something of a whole log, and may be compared with those of others.
 *
 * @property kind what the log is of.
 * @property keys what is measured.
 * @property uncertainty within which the resistance of the battery is known, in milliohms (95 %); NaN without one.
 */
public class LogFigures internal constructor(
    public val kind: MatchKind,
    public val keys: List<FigureKey>,
    internal val values: DoubleArray,
    public val uncertainty: Double,
) {
    /** The figure for [key]; NaN for none. */
    public operator fun get(key: FigureKey): Double = keys.indexOf(key).let { if (it < 0) Double.NaN else values[it] }

    /** The value of the first figure of [signal], measured so; NaN for none. */
    public fun of(signal: String, measure: Measure): Double =
        keys.indexOfFirst { it.signal == signal && it.measure == measure }.let { if (it < 0) Double.NaN else values[it] }

    /** The resistance of battery and wiring in milliohms; NaN where the log does not tell. */
    public val resistance: Double get() = of(FigureKey.RESISTANCE, Measure.RESISTANCE)

    public companion object {
        /** Those of a log that has none. */
        public val NONE: LogFigures = LogFigures(MatchKind.UNKNOWN, emptyList(), DoubleArray(0), Double.NaN)
    }
}
