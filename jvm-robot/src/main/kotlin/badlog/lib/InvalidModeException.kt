package badlog.lib

/**
 * Thrown while a log is set up, when something is done too early or too late: a topic created before [BadLog.init] or
 * after [BadLog.finishInitialization], or the latter called twice. Never thrown by what a robot calls in its loop.
 */
public class InvalidModeException internal constructor(message: String?) : RuntimeException(message) {
    public constructor() : this(null)

    private companion object {
        const val serialVersionUID: Long = -2224779029484673090L
    }
}
