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
