package badlog.lib

/** Thrown during setup if a topic or a value is created with a name that is already taken. */
public class DuplicateNameException internal constructor(message: String?) : RuntimeException(message) {
    public constructor() : this(null)

    private companion object {
        const val serialVersionUID: Long = -6926313818013744704L
    }
}

/** Never thrown, because unusual names only cause a warning. It exists for programs that mention it. */
public class InvalidNameException : RuntimeException() {
    private companion object {
        const val serialVersionUID: Long = -2518114606252953907L
    }
}

/**
 * Thrown during setup by a call that is too early or too late. Either a topic is created before [BadLog.init] or after
 * [BadLog.finishInitialization], or the latter is called twice. Never thrown by the functions that a robot calls in its loop.
 */
public class InvalidModeException internal constructor(message: String?) : RuntimeException(message) {
    public constructor() : this(null)

    private companion object {
        const val serialVersionUID: Long = -2224779029484673090L
    }
}
