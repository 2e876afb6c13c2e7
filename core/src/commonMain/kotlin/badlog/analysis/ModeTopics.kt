package badlog.analysis

/**
 * Which topics of a recording tell when the robot was enabled. What they are called differs from log to log: whoever knows the
 * names finds them, and gives them to [LogView.identified].
 *
 * @property enabled the one that says when it was enabled; null for none.
 * @property autonomous the one that says when it was under its own control; null for none.
 */
public class ModeTopics(public val enabled: FlagTopic?, public val autonomous: FlagTopic?) {
    public companion object {
        /** None. */
        public val NONE: ModeTopics = ModeTopics(null, null)
    }
}

/**
 * A topic that says when something is so.
 *
 * @property topic its full name.
 * @property reading how it says so.
 */
public class FlagTopic(public val topic: String, public val reading: FlagReading)

/** How the samples of a topic say that something is so. A gap never does. */
public sealed interface FlagReading {
    /** Whether [sample] says so; where samples stand for texts, [states] are those. */
    public fun isSet(sample: Double, states: List<String>): Boolean

    /** By anything but 0. */
    public data object Truth : FlagReading {
        override fun isSet(sample: Double, states: List<String>): Boolean = sample != 0.0 && !sample.isNaN()
    }

    /** By 0, as a topic that says when the robot was disabled. */
    public data object Opposite : FlagReading {
        override fun isSet(sample: Double, states: List<String>): Boolean = sample == 0.0
    }

    /** By the bits from [first] to [last] of a word, counted from 0, the lowest, which are [number]. */
    public data class Bits(public val first: Int, public val last: Int, public val number: Long) : FlagReading {
        override fun isSet(sample: Double, states: List<String>): Boolean =
            sample.isFinite() && (sample.toLong() shr first) and ((2L shl (last - first)) - 1) == number
    }

    /** By a text that begins with [start], in any case of letters. */
    public data class Text(public val start: String) : FlagReading {
        override fun isSet(sample: Double, states: List<String>): Boolean =
            sample.isFinite() && states.getOrNull(sample.toInt())?.startsWith(start, ignoreCase = true) == true
    }
}
