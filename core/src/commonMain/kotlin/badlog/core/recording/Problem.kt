package badlog.core.recording

/**
 * Something that was wrong in a file: what, where, and how it was handled. Problems are data: every front end shows
 * them, none stops a file from opening.
 *
 * @property kind what sort of problem it is; it also gives the [severity].
 * @property message one sentence that a student understands.
 * @property line the physical line of the file, from 1, or null if the problem has no line.
 * @property topic the name of the topic concerned, or null.
 * @property count how often it occurred; [line] and [message] are those of the first time.
 * @property loss what was lost, over all occurrences.
 */
public data class Problem(
    public val kind: ProblemKind,
    public val message: String,
    public val line: Int? = null,
    public val topic: String? = null,
    public val count: Int = 1,
    public val loss: Loss = Loss.NONE,
) {
    /** How much it matters. */
    public val severity: Severity get() = kind.severity
}

/** How much a [Problem] matters to someone who reads the recording. */
public enum class Severity {
    /** Nothing is lost or doubtful; for information. */
    NOTE,

    /** Everything was kept, but some of it may have been read differently from how it was meant. */
    WARNING,

    /** Part of the file's data is lost. */
    ERROR,
}

/**
 * How much of a file was lost to a [Problem]: what was in the file, but is in no row of the recording. Data that never
 * reached the file cannot be known and is not counted.
 *
 * @property rows how many rows were dropped.
 * @property cells how many cells were dropped or emptied, whole or in part, including those of [rows].
 * @property bytes how many bytes of the file, after inflating, were skipped.
 */
public data class Loss(public val rows: Int = 0, public val cells: Int = 0, public val bytes: Long = 0) {
    /** Returns the sum of both. */
    public operator fun plus(other: Loss): Loss = Loss(rows + other.rows, cells + other.cells, bytes + other.bytes)

    public companion object {
        /** Nothing was lost. */
        public val NONE: Loss = Loss()
    }
}
