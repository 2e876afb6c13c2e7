package badlog.viewer.text

import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Severity

/** What front ends call how serious it is. */
val Problem.word: String
    get() = when (severity) {
        Severity.ERROR -> "lost"
        Severity.WARNING -> "warning"
        Severity.NOTE -> "hint"
    }

/**
 * Returns what [problems] mean for someone who relies on the file, such as `Data is missing in 2 places, 1 warning.`, or why it is not a
 * log at all. A front end may have [others] to warn of, besides what is wrong in the file.
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

/** Returns where [problem] occurred, and how often if its message does not say it: `line 12 · Arm/Angle · 3 times`. */
fun placeTextOf(problem: Problem): String = listOfNotNull(
    problem.line?.let { "line ${countText(it)}" },
    problem.topic,
    problem.count.takeIf { it > 1 && !problem.message.contains(Regex("\\b$it\\b")) }?.let { "${countText(it)} times" },
).joinToString(" · ")
