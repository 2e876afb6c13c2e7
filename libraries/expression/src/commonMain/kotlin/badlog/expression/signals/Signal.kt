package badlog.expression.signals

/**
 * What an expression may name.
 *
 * @property name the full name; `/` makes folders.
 * @property kind what its samples are.
 * @property unit the unit, `ul` or empty for none; only shown, never calculated with.
 */
public data class Signal(public val name: String, public val kind: SignalKind, public val unit: String = "")

/** What the samples of a [Signal] are. */
public enum class SignalKind {
    /** Numbers. */
    NUMBER,

    /** 0 for false and 1 for true. */
    CONDITION,

    /** Texts that stay until the next one, such as a state. */
    STATE,

    /** Texts that happen at a moment and then are over, such as the lines of an event log. */
    EVENT,
}
