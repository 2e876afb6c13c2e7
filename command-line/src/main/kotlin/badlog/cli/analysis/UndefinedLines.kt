package badlog.cli.analysis

import badlog.expression.ExpressionError

/** A line or more for each of [errors], after two blanks: the virtual topics that a log does not get, and why. */
internal fun undefinedLines(errors: List<ExpressionError>): List<String> = errors.flatMap { it.pointed().lines() }.map { "  $it" }
