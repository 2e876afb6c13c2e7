package badlog.rules.number

import badlog.signals.match.MatchKind

/**
 * The key of a number: its measure, and the topic.
 *
 * @property signal the signal of the topic, or [RESISTANCE].
 * @property topic its full name.
 * @property unit the unit of the number, empty for none.
 */
data class NumberKey(val signal: String, val topic: String, val measure: Measure, val unit: String) {
    companion object {
        /** The signal of the number calculated from battery voltage and total current. */
        const val RESISTANCE: String = "battery resistance"
    }
}

/**
 * Numbers that summarize a whole log, for comparison with other logs.
 *
 * @property kind the kind of run.
 * @property keys the keys of the numbers.
 * @property uncertainty the uncertainty of the battery's resistance, in milliohms (95 %); NaN if there is none.
 * @property beginsEnabled whether the robot was enabled when the log began, as it is after a restart of the code in a match.
 * @property endsEnabled whether it was enabled when the log ended.
 * @property distributions the distributions of some signals' values.
 */
class LogNumbers internal constructor(
    val kind: MatchKind,
    val keys: List<NumberKey>,
    internal val values: DoubleArray,
    val uncertainty: Double,
    val beginsEnabled: Boolean = false,
    val endsEnabled: Boolean = false,
    val distributions: List<Distribution> = emptyList(),
) {
    /** Returns the number for [key]; NaN for none. */
    operator fun get(key: NumberKey): Double = keys.indexOf(key).let { if (it < 0) Double.NaN else values[it] }

    /** Returns the value of the first number of [signal] with [measure]; NaN for none. */
    fun of(signal: String, measure: Measure): Double =
        keys.indexOfFirst { it.signal == signal && it.measure == measure }.let { if (it < 0) Double.NaN else values[it] }

    /** Returns the distribution of the values of [signal]; null if the log does not show it. */
    fun distributionOf(signal: String): Distribution? = distributions.find { it.signal == signal }

    /** The resistance of battery and wiring in milliohms; NaN if the log does not show it. */
    val resistance: Double get() = of(NumberKey.RESISTANCE, Measure.RESISTANCE)

    companion object {
        val NONE: LogNumbers = LogNumbers(MatchKind.UNKNOWN, emptyList(), DoubleArray(0), Double.NaN)
    }
}
