package badlog.recording

/** How much a [Problem] matters to someone who reads the recording. */
public enum class Severity {
    /** Nothing is lost or doubtful; said so that nobody wonders. */
    NOTE,

    /** Everything was kept, but some of it was read in a way that its writer may not have meant. */
    WARNING,

    /** Something of the file is lost. */
    ERROR,
}
