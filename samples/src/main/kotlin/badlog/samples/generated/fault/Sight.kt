package badlog.samples.generated.fault

/** The visibility of a fault in a log. */
enum class Visibility {
    /** A mentor with this log alone could name the cause. */
    CAUSE,

    /** The log shows that something is wrong, but several causes would look the same. */
    SYMPTOM,

    /** Nothing in the log, or nothing that a healthy robot would not also do. */
    NOTHING,
}

/**
 * The visibility of a fault in the logs of one [Naming].
 *
 * @property reason the reason why they do not show the cause; empty if they do.
 */
data class Sight(val visibility: Visibility, val reason: String = "")
