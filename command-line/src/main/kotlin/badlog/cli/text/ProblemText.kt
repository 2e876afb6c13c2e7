package badlog.cli.text

import badlog.core.recording.Problem
import badlog.core.recording.Severity
import badlog.expression.ExpressionError

/** Returns a line or more for each of [problems], the worst first, indented by [indent]. */
internal fun problemLines(problems: List<Problem>, indent: String = ""): List<String> =
    problems.sortedByDescending { it.severity }.map { lineOf(it, indent) }

/** Returns a line or more for each loss among [problems], indented by two spaces, for people who converted the log. */
internal fun lossLines(problems: List<Problem>): List<String> =
    problemLines(problems.filter { it.severity == Severity.ERROR }, indent = "  ")

private fun lineOf(problem: Problem, indent: String): String {
    val line = problem.line?.let { "line $it: " }.orEmpty()
    val isCounted = problem.count == 1 || problem.message.contains(Regex("\\b${problem.count}\\b"))
    val times = if (isCounted) "" else " (${grouped(problem.count.toLong())} times)"
    return wrapped(indent + wordOf(problem.severity).padEnd(SEVERITY), line + problem.message + times)
}

/** The word is *hint* instead of *note*, because people know notes as texts of the team. */
private fun wordOf(severity: Severity) = if (severity == Severity.NOTE) "hint" else severity.name.lowercase()

private const val SEVERITY = 9

/**
 * Returns a line or more for each of [errors], indented by two spaces. Each is a virtual topic that could not be calculated, with the
 * reason.
 */
internal fun undefinedLines(errors: List<ExpressionError>): List<String> = errors.flatMap { it.pointed().lines() }.map { "  $it" }
