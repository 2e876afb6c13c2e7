package badlog.core.conformance

import badlog.core.recording.CellCounts
import badlog.core.recording.ProblemKind
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TopicKind
import badlog.core.recording.Value

/**
 * The reading of one corpus file that every reader must produce. Order matters everywhere except in the two lists of problems.
 *
 * @property attributeProblems problems of the attributes: found when they are applied, not when the file is read.
 */
internal class Expectation(
    val format: RecordingFormat,
    val values: List<Value>,
    val topics: List<ExpectedTopic>,
    val rowCount: Int,
    val problems: List<ExpectedProblem>,
    val attributeProblems: List<ExpectedProblem>,
)

/**
 * @property samples for each row a number or null for a gap; NaN and infinities where the file says so.
 * @property texts the rows that hold a text, each with it.
 */
internal class ExpectedTopic(
    val name: String,
    val unit: String,
    val attributes: List<String>,
    val kind: TopicKind,
    val counts: CellCounts,
    val samples: List<Double?>,
    val texts: List<Pair<Int, String>>,
)

/** A problem without its message, which is left to the reader. */
internal data class ExpectedProblem(val kind: ProblemKind, val line: Int? = null, val topic: String? = null)
