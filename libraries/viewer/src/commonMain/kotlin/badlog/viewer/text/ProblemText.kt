package badlog.viewer.text

import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Severity

/** The displayed word for the severity of a problem. */
val Problem.word: String
    get() = when (severity) {
        Severity.ERROR -> "lost"
        Severity.WARNING -> "warning"
        Severity.NOTE -> "hint"
    }

/**
 * Returns a summary of [problems] for a reader of the file: `Data is missing in 2 places, 1 warning.` For a file that is not a log, it is
 * the reason. A front end may add [others], the number of its own warnings.
 */
fun problemSummary(problems: List<Problem>, others: Int = 0): String {
    val unreadable = problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING || it.kind == ProblemKind.EMPTY_FILE }
    if (unreadable != null) return unreadable.message
    fun count(severity: Severity) = problems.count { it.severity == severity }
    val lost = count(Severity.ERROR)
    val warnings = count(Severity.WARNING) + others
    val hints = count(Severity.NOTE)
    return listOfNotNull(
        if (lost > 0) "Data is missing in ${countText(lost, "place")}" else "Complete",
        if (warnings > 0) countText(warnings, "warning") else null,
        if (hints > 0) countText(hints, "hint") else null,
    ).joinToString(postfix = ".")
}

/** Returns the place of [problem], and its count if the message does not contain it: `line 12 · Arm/Angle · 3 times`. */
fun placeTextOf(problem: Problem): String = listOfNotNull(
    problem.line?.let { "line ${countText(it)}" },
    problem.topic,
    problem.count.takeIf { it > 1 && !problem.message.contains(Regex("\\b$it\\b")) }?.let { "${countText(it)} times" },
).joinToString(" · ")
