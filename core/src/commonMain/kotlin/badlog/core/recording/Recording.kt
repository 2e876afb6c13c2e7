package badlog.core.recording

/**
 * The content of one log file: everything that could be kept, and the problems found.
 *
 * @property format the format, recognized by the content.
 * @property headerLine the JSON of the file's first line exactly as in the file, or null if it has none.
 * @property values the values, in the order of the file.
 * @property topics the topics, in the order of the file's header.
 * @property rowCount the number of samples of each topic that shares rows with the others; 0 if all topics have [times of their
 *   own][Topic.times], as in a WPILOG, which has no rows. [sampleCount] counts the samples of all topics.
 * @property problems the problems, in the order in which they were found.
 */
public class Recording(
    public val format: RecordingFormat,
    public val headerLine: String?,
    public val values: List<Value>,
    public val topics: List<Topic>,
    public val rowCount: Int,
    public val problems: List<Problem>,
) {
    /** Returns this recording with some of its parts replaced. */
    public fun copy(
        format: RecordingFormat = this.format,
        headerLine: String? = this.headerLine,
        values: List<Value> = this.values,
        topics: List<Topic> = this.topics,
        rowCount: Int = this.rowCount,
        problems: List<Problem> = this.problems,
    ): Recording = Recording(format, headerLine, values, topics, rowCount, problems)

    /** The number of samples of all topics together, gaps included. */
    public val sampleCount: Long get() = topics.sumOf { it.size.toLong() }

    /**
     * A sentence that says why the bytes are not a log at all; null if they are one. If it is set, there is nothing to show but [problems].
     */
    public val refusal: String? get() = problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING }?.message

    /** Whether the bytes are a log: there is no [refusal]. */
    public val isReadable: Boolean get() = refusal == null

    /** True if part of the file's data is lost: one of [problems] is an [error][Severity.ERROR]. */
    public val isSalvaged: Boolean get() = problems.any { it.severity == Severity.ERROR }
}

/**
 * A name and a text that were known when the recording began, such as the match number.
 *
 * @property name the full name; `/` makes folders, see [PathName].
 * @property text the value; may be empty.
 */
public data class Value(public val name: String, public val text: String)
