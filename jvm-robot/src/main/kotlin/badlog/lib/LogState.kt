package badlog.lib

/** The states of a [BadLog]. */
public enum class LogState {
    /** Topics and values can be created; nothing is logged yet. */
    SETTING_UP,

    /** Rows are being written. */
    LOGGING,

    /** Rows cannot currently be written, or go to a file that was deleted; they are lost and counted. */
    FAILING,

    /** The log was closed; calls are ignored. */
    CLOSED,
}
