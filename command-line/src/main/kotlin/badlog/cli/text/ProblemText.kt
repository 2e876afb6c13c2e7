package badlog.cli.text

import badlog.recording.Problem

/** A line or more for each of [problems], the worst first, after [indent]. */
internal fun problemLines(problems: List<Problem>, indent: String = ""): List<String> =
    problems.sortedByDescending { it.severity }.map { lineOf(it, indent) }

private fun lineOf(problem: Problem, indent: String): String {
    val line = problem.line?.let { "line $it: " }.orEmpty()
    val times = if (problem.count > 1) " (${grouped(problem.count.toLong())} times)" else ""
    return wrapped(indent + problem.severity.name.lowercase().padEnd(SEVERITY), line + problem.message + times)
}

private const val SEVERITY = 9
