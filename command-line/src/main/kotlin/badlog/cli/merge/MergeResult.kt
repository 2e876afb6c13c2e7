package badlog.cli.merge

import badlog.cli.command.Outcome
import badlog.cli.output.Omissions
import badlog.core.recording.Problem
import java.nio.file.Path

/** One log that was made of several. */
internal sealed interface MergeResult {
    /** The logs, at their times in the result. */
    val moved: MovedLogs

    /** The problems of all these logs. */
    val problems: List<Problem> get() = moved.parts.flatMap { it.recording.problems }

    /** The outcome of the merge. */
    val outcome: Outcome

    /**
     * Returns remarks for a person who reads that log in place of the others, each as one or more lines.
     *
     * @param isOfDoubts whether to return only doubts.
     */
    fun remarks(isOfDoubts: Boolean): List<String>

    /** A log at [target], made by [merge], without [leftOut]. */
    class Made(private val merge: Merged, override val moved: MovedLogs, private val target: Path, private val leftOut: Omissions) :
        MergeResult {
        override fun remarks(isOfDoubts: Boolean): List<String> {
            // A single edge may match by chance, and samples before 0 are lost.
            val moves = if (isOfDoubts) moved.moves.filter { it.edges == 1 || it.early > 0 } else moved.moves
            return clockLines(moves, moved.pauses) + renamedLines(merge) + leftOut.lines
        }

        override val outcome: Outcome get() = mergeOutcome(merge, moved, target, leftOut)
    }

    /**
     * A ZIP at [target] with the logs as they are. It does not state the clocks of the logs [open].
     *
     * @param doubts a sentence about each log near them that may be of another match, and is left out.
     */
    class Zipped(
        override val moved: MovedLogs,
        private val target: Path,
        private val open: List<LogPart>,
        private val doubts: List<String>,
    ) : MergeResult {
        override fun remarks(isOfDoubts: Boolean): List<String> = emptyList()

        override val outcome: Outcome get() = zipOutcome(moved, target, open, doubts)
    }
}
