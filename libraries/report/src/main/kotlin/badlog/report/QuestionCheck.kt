package badlog.report

import badlog.expression.ExpressionError
import badlog.expression.ParsedQuestion
import badlog.expression.Question
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import badlog.expression.syntax.ExpressionErrorKind

/**
 * Returns the mistake in [question] that does not depend on a log's topics; null if none is certain. Names of topics are guessed, so some
 * mistakes only show for an actual log. A question that a usual name could make valid is not reported.
 */
internal fun errorForEveryLog(question: String): ExpressionError? {
    val guessed = ArrayList<Signal>()
    repeat(MAX_NAMES) {
        val error = read(question, guessed) as? ExpressionError ?: return null
        if (error.kind != ExpressionErrorKind.UNKNOWN_TOPIC) return error.takeIf { isForAnyLog(it, guessed) }
        guessed += Signal(nameIn(error), SignalKind.NUMBER, "")
    }
    return null
}

private fun read(question: String, signals: List<Signal>): ParsedQuestion = Question.parse(question, Vocabulary(signals.toList()))

/** A name may contain words, operators, and pairs of parentheses or quotes; only errors in the rest are certain. */
private fun isForAnyLog(error: ExpressionError, guessed: List<Signal>): Boolean = when (error.kind) {
    ExpressionErrorKind.LIMIT -> true

    ExpressionErrorKind.TYPE -> guessed.isEmpty()

    else -> {
        val place = error.text.substring(error.from, error.until)
        val isQuoteOpen = error.until == error.text.length && place.length > 1 && place[0] in QUOTES
        error.from == error.text.length || place == "(" || place == ")" || isQuoteOpen
    }
}

private fun nameIn(error: ExpressionError): String {
    val written = error.text.substring(error.from, error.until)
    val quote = written[0]
    return if (quote in QUOTES) written.substring(1, written.length - 1).replace("$quote$quote", "$quote") else written
}

private const val QUOTES = "\"'`"

/** Far more names than a question has. */
private const val MAX_NAMES = 100
