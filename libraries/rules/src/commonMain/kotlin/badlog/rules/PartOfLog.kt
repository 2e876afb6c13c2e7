package badlog.rules

import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Value

/** The name of the value that marks a log as part of another one. */
const val PART_VALUE: String = "Part"

/** The start or the end of a run of the robot's program, which some files lack. */
internal enum class LogEdge { START, END }

/**
 * Returns whether this recording contains the [edge] of a run. A part that was cut out of a log has neither edge; nor has a log with an
 * unreadable header. A file that was copied in part, or is still being written, has no end: it stops in the middle of a row or a record.
 */
internal fun Recording.has(edge: LogEdge): Boolean {
    val damage = if (edge == LogEdge.START) NO_START else NO_END
    return values.none { it.name == PART_VALUE } && problems.none { it.kind in damage }
}

private val NO_START = setOf(ProblemKind.HEADER_UNREADABLE)
private val NO_END = NO_START + setOf(
    ProblemKind.GZIP_CUT,
    ProblemKind.ROW_CUT,
    ProblemKind.LAST_CELL_CUT,
    ProblemKind.RECORD_CUT,
    ProblemKind.RECORDS_LOST,
    ProblemKind.NUL_HOLE,
    ProblemKind.TOO_MANY_ROWS,
)

/** Returns these values of a log, plus one that marks it as a part. [text] names the part, such as `90 s to 98.5 s`. */
fun List<Value>.ofPart(text: String): List<Value> = filter { it.name != PART_VALUE } + Value(PART_VALUE, text)
