package badlog.recording

/** The format that a [Recording] was read from. */
public enum class RecordingFormat {
    /** A JSON line, then CSV. */
    BAG,

    /** CSV alone: a bag without units, attributes and values. */
    CSV,

    /** The log of WPILib's DataLog, in which each topic has times of its own. */
    WPILOG,
}
