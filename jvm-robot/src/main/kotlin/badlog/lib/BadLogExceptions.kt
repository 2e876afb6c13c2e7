package badlog.lib

/** Thrown while a log is set up, when a topic or a value is created under a name that another one has. */
public class DuplicateNameException internal constructor(message: String?) : RuntimeException(message) {
    public constructor() : this(null)

    private companion object {
        const val serialVersionUID: Long = -6926313818013744704L
    }
}

/** Not thrown by anything: unusual names are only warned of. Here for programs that mention it. */
public class InvalidNameException : RuntimeException() {
    private companion object {
        const val serialVersionUID: Long = -2518114606252953907L
    }
}

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
