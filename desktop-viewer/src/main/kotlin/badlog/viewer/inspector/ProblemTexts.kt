package badlog.viewer.inspector

import badlog.recording.Problem
import badlog.recording.ProblemKind
import badlog.recording.Severity

/** What the window calls it. */
internal val Severity.title: String
    get() = when (this) {
        Severity.ERROR -> "lost"
        Severity.WARNING -> "warning"
        Severity.NOTE -> "note"
    }

/** Losses, then warnings, then notes; those of one severity stay in their order. */
internal fun worstFirst(problems: List<Problem>): List<Problem> = problems.sortedByDescending { it.severity }

/** In a sentence, what [problems] mean for someone who trusts the file. */
internal fun problemSummary(problems: List<Problem>): String {
    val losses = problems.filter { it.severity == Severity.ERROR }
    val doubts = problems.count { it.severity == Severity.WARNING }
    val unreadable = losses.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING || it.kind == ProblemKind.EMPTY_FILE }
    return when {
        unreadable != null -> unreadable.message
        losses.size == 1 -> "Something of this file is lost: ${losses.single().message}"
        losses.isNotEmpty() -> "Something of this file is lost, in ${losses.size} places: ${losses.first().message}"
        doubts == 1 -> "Nothing of this file is lost, but one thing in it is doubtful."
        doubts > 1 -> "Nothing of this file is lost, but $doubts things in it are doubtful."
        else -> "Nothing of this file is lost."
    }
}

/** Where and how often [problem] was met: `line 12 · Arm/Angle · 3 times`. */
internal fun placeOf(problem: Problem): String = listOfNotNull(
    problem.line?.let { "line $it" },
    problem.topic,
    problem.count.takeIf { it > 1 }?.let { "$it times" },
).joinToString(" · ")
