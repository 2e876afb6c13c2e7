package badlog.expression

import badlog.expression.syntax.ExpressionErrorKind
import badlog.expression.syntax.Function
import badlog.expression.syntax.SUGGESTION

/**
 * The mistake that makes a text an invalid expression.
 *
 * @property text the whole text.
 * @property from the index in [text] at which the mistake begins; at most its length.
 * @property until the index at which it ends; not before [from], and equal to it if something is missing.
 * @property kind the kind of mistake.
 * @property message a sentence about the mistake.
 */
class ExpressionError internal constructor(
    val text: String,
    val from: Int,
    val until: Int,
    val kind: ExpressionErrorKind,
    val message: String,
) : ParsedExpression,
    ParsedQuestion,
    ParsedVirtualTopic {
    /** Whether the mistake is the name of a function without operands. */
    val isFunctionAlone: Boolean get() = Function.called(text.substring(from, until)).isNotEmpty()

    /** Returns the message, and below it the text's line with a line of carets that point at the mistake. */
    fun pointed(): String {
        // On Node, a search from -1 looks at index 0.
        val lineFrom = if (from == 0) 0 else text.lastIndexOf('\n', from - 1) + 1
        val lineUntil = text.indexOf('\n', lineFrom).let { if (it < 0) text.length else it }
        // Every character takes one column, whatever it is.
        val line = text.substring(lineFrom, lineUntil).map { if (it.isISOControl()) ' ' else it }.joinToString("")
        val carets = maxOf(1, minOf(until, lineUntil) - from)
        return "$message\n$line\n${" ".repeat(from - lineFrom)}${"^".repeat(carets)}"
    }

    override fun toString(): String = message
}

/** Returns whether the [message] of an [ExpressionError] suggests another name. */
fun isSuggestion(message: String): Boolean = SUGGESTION in message
