package badlog.core.analysis

/**
 * The topics of a recording that show when the robot was enabled, and in which mode. Their names differ from log to log: code that knows
 * the names finds the topics, and passes them to [LogView.identified].
 *
 * @property enabled the topic that shows when it was enabled; null for none.
 * @property autonomous the topic that shows when it was autonomous; null for none.
 * @property test the topic that shows when it was in test mode, called utility from 2027 on; null for none.
 * @property opMode the name of the topic that holds the op mode's name; null for none.
 */
public class ModeTopics(
    public val enabled: FlagTopic?,
    public val autonomous: FlagTopic?,
    public val test: FlagTopic? = null,
    public val opMode: String? = null,
) {
    public companion object {
        /** No topics. */
        public val NONE: ModeTopics = ModeTopics(null, null)
    }
}

/**
 * A topic with samples that are read as true or false.
 *
 * @property topic its full name.
 * @property reading how to read its samples.
 */
public class FlagTopic(public val topic: String, public val reading: FlagReading)

/** The rule by which the samples of a topic are read as true or false. A gap is never true. */
public sealed interface FlagReading {
    /** Returns whether [sample] is read as true. If samples stand for texts, [states] has these texts. */
    public fun isSet(sample: Double, states: List<String>): Boolean

    /** Anything but 0 is true. */
    public data object Truth : FlagReading {
        override fun isSet(sample: Double, states: List<String>): Boolean = sample != 0.0 && !sample.isNaN()
    }

    /** 0 is true, as in a topic that shows when the robot was disabled. */
    public data object Opposite : FlagReading {
        override fun isSet(sample: Double, states: List<String>): Boolean = sample == 0.0
    }

    /** True if the bits from [first] to [last] of a word, counted from 0 for the lowest, are [number]. */
    public data class Bits(public val first: Int, public val last: Int, public val number: Long) : FlagReading {
        override fun isSet(sample: Double, states: List<String>): Boolean =
            sample.isFinite() && (sample.toLong() shr first) and ((2L shl (last - first)) - 1) == number
    }

    /** A text that begins with [start] is true; letter case is ignored. */
    public data class Text(public val start: String) : FlagReading {
        override fun isSet(sample: Double, states: List<String>): Boolean =
            sample.isFinite() && states.getOrNull(sample.toInt())?.startsWith(start, ignoreCase = true) == true
    }
}
