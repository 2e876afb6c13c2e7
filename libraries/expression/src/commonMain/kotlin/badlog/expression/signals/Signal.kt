package badlog.expression.signals

/**
 * Something that an expression can name.
 *
 * @property name the full name; `/` makes folders.
 * @property kind the kind of its samples.
 * @property unit the unit; `ul` or empty for none.
 */
data class Signal(val name: String, val kind: SignalKind, val unit: String = "")

/** The kinds of samples of a [Signal]. */
enum class SignalKind {
    /** Numbers. */
    NUMBER,

    /** 0 for false and 1 for true. */
    CONDITION,

    /** Texts that hold until the next one, such as a state. */
    STATE,

    /** Texts that occur at a moment, such as the entries of an event log. */
    EVENT,
}
