package badlog.expression

/** What a part of an expression gives, and how an error calls it. */
internal enum class Kind(val title: String) {
    NUMBER("a number"),

    /** A number of seconds that is written with its unit; a number everywhere else. */
    TIME("a time"),

    /** Counts as 0 and 1 where a number is needed. */
    CONDITION("a condition"),
    TEXT("a text"),
    ;

    val isNumeric: Boolean get() = this != TEXT
}

/**
 * What a node gives: its [kind], one for each moment or one for the whole recording.
 *
 * @property isMomentary whether each is over at once, as events are.
 */
internal data class Type(val kind: Kind, val isOverTime: Boolean, val isMomentary: Boolean = false)
