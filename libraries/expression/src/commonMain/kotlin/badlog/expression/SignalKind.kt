package badlog.expression

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
