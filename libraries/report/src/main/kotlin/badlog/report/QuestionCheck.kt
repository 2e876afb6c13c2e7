package badlog.report

import badlog.expression.ExpressionError
import badlog.expression.ParsedQuestion
import badlog.expression.Question
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import badlog.expression.syntax.ExpressionErrorKind

/**
 * What is wrong with [question] whatever topics a log has, or null. What topics might be called is guessed, so some mistakes still
 * only show when a log is asked; but none is reported that a usual name could make right.
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

/** A name may have words, operators, and parentheses or quotes in pairs in it; only what is left of those is beyond doubt. */
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

/** Far more than a question asks about. */
private const val MAX_NAMES = 100
