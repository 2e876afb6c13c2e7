package badlog.recording

/**
 * Something that was wrong in a file, where, and what was done about it. Problems are data: every front end shows them,
 * none stops a file from opening.
 *
 * @property kind what sort of problem it is; it also gives the [severity].
 * @property message one sentence that a student understands.
 * @property line the physical line of the file, from 1, or null where the problem has no line.
 * @property topic the name of the topic concerned, or null.
 * @property count how often it was met; [line] and [message] speak of the first.
 * @property loss what it cost, in all of its occurrences.
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

    /** Everything was kept, but some of it was read in a way that its writer may not have meant. */
    WARNING,

    /** Something of the file is lost. */
    ERROR,
}

/**
 * How much of a file a [Problem] cost: what stood there, and is in no row of the recording. What a cut took before it came to
 * the file cannot be known and is not counted.
 *
 * @property rows how many rows were dropped.
 * @property cells how many cells were dropped or emptied, whole ones and rests of them, those of [rows] too.
 * @property bytes how many bytes of the file, inflated, were given up.
 */
public data class Loss(public val rows: Int = 0, public val cells: Int = 0, public val bytes: Long = 0) {
    /** The sum of both. */
    public operator fun plus(other: Loss): Loss = Loss(rows + other.rows, cells + other.cells, bytes + other.bytes)

    public companion object {
        /** Nothing was lost. */
        public val NONE: Loss = Loss()
    }
}
