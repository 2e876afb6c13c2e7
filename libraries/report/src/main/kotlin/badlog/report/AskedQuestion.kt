package badlog.report

import badlog.expression.ExpressionError
import badlog.expression.ParsedQuestion
import badlog.expression.Question
import badlog.expression.syntax.ExpressionErrorKind
import badlog.signals.LogShape
import badlog.signals.QuestionNames
import badlog.signals.vocabulary.SignalVocabulary

/**
 * Reads the question [text] for logs of [shape], with [names]. The message about an unknown name suggests names of all [signals], not only
 * of signals that share words with the question.
 */
internal fun askedQuestion(text: String, shape: LogShape, names: QuestionNames, signals: SignalVocabulary): ParsedQuestion {
    val asked = Question.parse(text, names.vocabulary)
    val isNameUnknown = asked is ExpressionError && asked.kind == ExpressionErrorKind.UNKNOWN_TOPIC
    if (!isNameUnknown) return asked
    val withAll = Question.parse(text, QuestionNames(signals, shape).vocabulary) as? ExpressionError
    return withAll?.takeIf { it.kind == ExpressionErrorKind.UNKNOWN_TOPIC } ?: asked
}
