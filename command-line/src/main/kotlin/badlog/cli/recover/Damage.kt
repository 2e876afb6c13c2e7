package badlog.cli.recover

import badlog.cli.command.Outcome
import badlog.cli.output.Omissions
import badlog.cli.text.LossJson
import badlog.cli.text.ProblemJson
import badlog.cli.text.counted
import badlog.cli.text.jsonOf
import badlog.cli.text.problemLines
import badlog.core.recording.Loss
import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Severity
import kotlinx.serialization.Serializable
import java.nio.file.Path

/** The losses and repairs of a damaged log. */
internal class Damage(private val recording: Recording) {
    private val problems: List<Problem> =
        recording.problems.filter { it.severity == Severity.ERROR || it.kind in MENDED }

    /** Whether a clean log would differ from this one. */
    val isDamaged: Boolean get() = problems.isNotEmpty()

    private val total: Loss = problems.map { it.loss }.fold(Loss.NONE, Loss::plus)

    /** Whether data is lost that never reached the file, in an unknown amount. */
    private val isOpenEnded: Boolean = problems.any { it.kind in OPEN_ENDED }

    /** The number of bytes lost at the end, 0 if none; null if data is lost elsewhere. */
    val bytesAtEnd: Long? = if (problems.all { it.kind in AT_END }) total.bytes else null

    // Other logs have records instead of rows of cells.
    private val hasRows: Boolean = recording.format.hasRows

    /** Returns the outcome for [file]. Its clean log is [target], without [leftOut]; null if it needs none. */
    fun outcome(file: Path, target: Path?, leftOut: Omissions): Outcome {
        val json = RecoverJson(
            target?.toString(),
            recording.rowCount,
            recording.sampleCount,
            LossJson(total),
            isOpenEnded,
            problems.map(::ProblemJson),
            leftOut.all,
        )
        return Outcome(recording.isSalvaged, text(file, target, leftOut), jsonOf(json))
    }

    private fun text(file: Path, target: Path?, leftOut: Omissions): String {
        val lines = ArrayList<String>()
        lines += if (target == null) "$file: whole; nothing to recover" else "$file -> $target"
        val kept = if (hasRows) counted(recording.rowCount.toLong(), "row") else counted(recording.sampleCount, "sample")
        if (target != null) lines += "  kept $kept, lost ${lostText()}"
        return (lines + problemLines(problems, indent = "  ") + leftOut.lines).joinToString("\n")
    }

    private fun lostText(): String {
        val parts = listOf(total.rows.toLong() to "row", total.cells.toLong() to if (hasRows) "cell" else "record", total.bytes to "byte")
            .filter { it.first > 0 }
            .joinToString { (count, noun) -> counted(count, noun) }
        return when {
            !isOpenEnded -> parts.ifEmpty { "nothing" }
            parts.isEmpty() -> "what came after the damage"
            else -> "$parts, and what came after the damage"
        }
    }

    private companion object {
        /** The problems that lose no data, but that a clean log does not have. */
        val MENDED = setOf(
            ProblemKind.LINES_JOINED,
            ProblemKind.QUOTES_REPAIRED,
            ProblemKind.ROW_SHORT,
            ProblemKind.NOT_UTF8,
            ProblemKind.DECIMAL_COMMA,
            ProblemKind.NAME_IN_DOUBT,
        )

        /** The problems that lose only the end of a log. */
        val AT_END = setOf(ProblemKind.RECORD_CUT, ProblemKind.RECORDS_LOST, ProblemKind.GZIP_CUT)

        /** The problems that leave a rest of unknown size, which was never written or cannot be read. */
        val OPEN_ENDED = setOf(ProblemKind.GZIP_CUT)
    }
}

@Serializable
private class RecoverJson(
    private val output: String?,
    private val rows: Int,
    private val samples: Long,
    private val lost: LossJson,
    private val lostMore: Boolean,
    private val problems: List<ProblemJson>,
    private val leftOut: List<String>,
)
