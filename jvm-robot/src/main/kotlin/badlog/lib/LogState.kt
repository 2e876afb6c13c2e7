package badlog.lib

/** What a [BadLog] is doing. */
public enum class LogState {
    /** Topics and values can be created; nothing is logged yet. */
    SETTING_UP,

    /** Rows are being written. */
    LOGGING,

    /** Rows cannot be written at the moment, or end up in a file that was deleted; they are lost, and counted. */
    FAILING,

    /** It was closed; calls are ignored. */
    CLOSED,
}
