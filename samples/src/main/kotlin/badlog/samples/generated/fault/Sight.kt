package badlog.samples.generated.fault

/** How much of a fault a log shows. */
enum class Visibility {
    /** A mentor with this log alone could name the cause. */
    CAUSE,

    /** The log shows that something is wrong, but several causes would look the same. */
    SYMPTOM,

    /** Nothing in the log, or nothing that a healthy robot would not also do. */
    NOTHING,
}

/**
 * What the logs of one [Naming] show of a fault.
 *
 * @property reason why they do not show the cause; empty if they do.
 */
data class Sight(val visibility: Visibility, val reason: String = "")
