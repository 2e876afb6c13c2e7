package badlog.core.recording

/**
 * A problem in a file: its kind, its place, and how it was handled. Problems are data: every front end shows them, and none stops a file
 * from opening.
 *
 * @property kind the kind of the problem, which also determines the [severity].
 * @property message one sentence that a student understands.
 * @property line the physical line of the file, from 1, or null if the problem has no line.
 * @property topic the name of the topic concerned, or null.
 * @property count the number of occurrences; [line] and [message] describe the first occurrence.
 * @property loss the loss over all occurrences.
 */
public data class Problem(
    public val kind: ProblemKind,
    public val message: String,
    public val line: Int? = null,
    public val topic: String? = null,
    public val count: Int = 1,
    public val loss: Loss = Loss.NONE,
) {
    /** The importance of the problem, from its [kind]. */
    public val severity: Severity get() = kind.severity
}

/** The importance of a [Problem] to someone who reads the recording. */
public enum class Severity {
    /** Nothing is lost or doubtful: for information only. */
    NOTE,

    /** Everything was kept, but some of it may have been read differently than intended. */
    WARNING,

    /** Part of the file's data is lost. */
    ERROR,
}

/**
 * The part of a file that was lost to a [Problem]. It was in the file, but is in no row of the recording. Data that never reached the file
 * is not counted, because it is not known.
 *
 * @property rows the number of dropped rows.
 * @property cells the number of cells that were dropped or emptied, whole or in part, including the cells of [rows].
 * @property bytes the number of skipped bytes, counted after inflating.
 */
public data class Loss(public val rows: Int = 0, public val cells: Int = 0, public val bytes: Long = 0) {
    /** Returns the sum of both. */
    public operator fun plus(other: Loss): Loss = Loss(rows + other.rows, cells + other.cells, bytes + other.bytes)

    public companion object {
        /** Nothing was lost. */
        public val NONE: Loss = Loss()
    }
}
