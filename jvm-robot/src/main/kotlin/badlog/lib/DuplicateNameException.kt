package badlog.lib

/** Thrown while a log is set up, when a topic or a value is created under a name that another one has. */
public class DuplicateNameException internal constructor(message: String?) : RuntimeException(message) {
    public constructor() : this(null)

    private companion object {
        const val serialVersionUID: Long = -6926313818013744704L
    }
}
