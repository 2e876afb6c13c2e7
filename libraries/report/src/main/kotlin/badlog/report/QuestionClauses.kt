package badlog.report

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.recording.Value
import badlog.expression.Expression
import badlog.expression.ExpressionError
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.expression.signals.Vocabulary

/**
 * The clauses of a question that select logs: `min(battery) where Match Type = 'Playoff' lowest 3`.
 *
 * @property question the question for each log.
 * @property condition the condition for a log's header values, as an expression; null for none.
 * @property count the number of logs to select; null for all.
 * @property isLowest whether to select the lowest numbers, rather than the highest.
 */
internal class QuestionClauses private constructor(val question: String, val condition: String?, val count: Int?, val isLowest: Boolean) {
    companion object {
        private val RANK =
            Regex("(.*\\S)\\s+(lowest|highest)\\s+([1-9][0-9]{0,5})\\s*", setOf(RegexOption.DOT_MATCHES_ALL, RegexOption.IGNORE_CASE))
        private const val WHERE = " where "

        fun of(text: String): QuestionClauses {
            val rank = RANK.matchEntire(text)
            val rest = rank?.groupValues?.get(1) ?: text
            val where = whereIn(rest)
            return QuestionClauses(
                question = if (where < 0) rest else rest.substring(0, where),
                condition = if (where < 0) null else rest.substring(where + WHERE.length),
                count = rank?.groupValues?.get(3)?.toInt(),
                isLowest = rank?.groupValues?.get(2).equals("lowest", ignoreCase = true),
            )
        }

        /** Returns the place of `where` outside quotes and parentheses; negative if there is none. */
        private fun whereIn(text: String): Int {
            var quote = ' '
            var depth = 0
            for ((i, character) in text.withIndex()) {
                when {
                    quote != ' ' -> if (character == quote) quote = ' '
                    character in "'\"`" -> quote = character
                    character == '(' -> depth++
                    character == ')' -> depth--
                    depth == 0 && text.startsWith(WHERE, i, ignoreCase = true) -> return i
                }
            }
            return -1
        }
    }
}

/** Returns whether [condition] is true for a log with the header values [values]. If it is invalid for them, also returns the error. */
internal fun holdsFor(values: List<Value>, condition: String): Pair<Boolean, Reply.NotAsked?> {
    val signals = HeaderSignals(values)
    return when (val parsed = Expression.parse(condition, signals.vocabulary)) {
        is ExpressionError -> false to notAsked(parsed, isOfHeader = true)
        is Expression -> parsed.answer(signals).matches to null
    }
}

/** The header values of a log as signals: numbers and texts that never change. */
private class HeaderSignals(values: List<Value>) : Signals {
    private val texts = values.associate { it.name to it.text.trim() }

    override val vocabulary = Vocabulary(
        texts.map { (name, text) -> Signal(name, if (text.toDoubleOrNull() == null) SignalKind.STATE else SignalKind.NUMBER) },
        hasTime = true,
        thing = "header value",
    )

    override fun series(name: String): Series = Series(doubleArrayOf(0.0), doubleArrayOf(texts.getValue(name).toDoubleOrNull() ?: 0.0))

    override fun states(name: String): List<String> = listOf(texts.getValue(name))

    override val enabled: List<EnabledSpan>? get() = null

    override val range: Span get() = Span(0.0, 1.0)

    override val timeUnit: String get() = "s"

    override val axis: Series get() = Series(doubleArrayOf(0.0), doubleArrayOf(0.0))

    override val rows: DoubleArray? get() = null
}
