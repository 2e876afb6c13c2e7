package badlog.expression

import badlog.expression.samples.Column
import badlog.expression.samples.Scalar
import badlog.expression.samples.Value
import badlog.expression.samples.matches
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.expression.signals.Vocabulary
import badlog.expression.syntax.ExpressionErrorKind
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Node

/** The result of parsing: a [Question], or the [ExpressionError] that says why it failed. */
sealed interface ParsedQuestion

/**
 * A question about a log. It is an [Expression], an expression for each of several topics or states, or a list of occurrences. Examples of
 * the last two are `max("PDP/Current *") by topic`, `total by State`, and `each(Browned Out, State)`, which lists each occurrence with the
 * values just before.
 */
sealed class Question : ParsedQuestion {
    /** Returns the answer for [signals]. */
    abstract fun answer(signals: Signals): Answer

    private class Plain(val expression: Expression) : Question() {
        override fun answer(signals: Signals) = expression.answer(signals)
    }

    private class ByTopic(val parts: List<Pair<String, Expression>>) : Question() {
        override fun answer(signals: Signals) = grouped(parts, signals)
    }

    private class ByState(val body: String, val key: Signal, val vocabulary: Vocabulary) : Question() {
        override fun answer(signals: Signals): Answer {
            val name = "\"${key.name.replace("\"", "\"\"")}\""
            val conditions = if (key.kind == SignalKind.CONDITION) {
                listOf("true" to name, "false" to "not $name")
            } else {
                signals.states(key.name).distinct().map { it to "$name == '${it.replace("'", "''")}'" }
            }
            val parts = conditions.mapNotNull { (group, condition) ->
                (Expression.parse(within(body, condition, vocabulary), vocabulary) as? Expression)?.let { group to it }
            }
            return grouped(parts, signals)
        }
    }

    private class Each(val condition: Expression, val others: List<Expression>) : Question() {
        override fun answer(signals: Signals): Answer {
            val answer = condition.answer(signals)
            val values = others.map { it to Evaluation(signals, it.root.id + 1).valueOf(it.root) }
            val occurrences = answer.spans.map { span ->
                Occurrence(
                    span,
                    values.map { (expression, value) ->
                        expression.text.trim() to
                            textBefore(value, span.from, expression, signals)
                    },
                )
            }
            return answer.run { Answer(outcome, spans, times, quantities, timeUnit, reason, occurrences) }
        }
    }

    companion object {
        /** Reads [text] with the names of [vocabulary]. Never throws, whatever the text. */
        fun parse(text: String, vocabulary: Vocabulary): ParsedQuestion {
            val parsed = Expression.parse(text, vocabulary)
            if (parsed is Expression) return Plain(parsed)
            val error = parsed as ExpressionError
            val by = lastOutside(text, " by ")
            return when {
                by > 0 -> grouped(text, by, vocabulary)
                text.trimStart().startsWith("each(", ignoreCase = true) && text.trimEnd().endsWith(')') -> each(text, vocabulary)
                else -> error
            }
        }

        private fun grouped(text: String, by: Int, vocabulary: Vocabulary): ParsedQuestion {
            val body = text.substring(0, by)
            val keyFrom = by + BY.length
            val key = text.substring(keyFrom).trim()
            if (key.equals("topic", ignoreCase = true)) return byTopic(text, body, keyFrom, vocabulary)
            val changes = Expression.parse(CHANGED + text.substring(keyFrom) + ")", vocabulary)
            if (changes is ExpressionError) {
                fun positionInText(at: Int) = (at - CHANGED.length + keyFrom).coerceIn(keyFrom, text.length)
                return ExpressionError(text, positionInText(changes.from), positionInText(changes.until), changes.kind, changes.message)
            }
            val signal = vocabulary.signals.find { it.name == (changes as Expression).topics.firstOrNull() }
            // “time” is not a topic, and a number, too.
            if (signal == null || signal.kind == SignalKind.NUMBER) {
                val message = "“${signal?.name ?: key}” is a number; “by” needs a signal with states, or “topic”."
                return ExpressionError(text, keyFrom, text.length, ExpressionErrorKind.TYPE, message)
            }
            val whole = body.trim().lowercase()
            if (whole !in FUNCTIONS_OF_STATE) {
                val parsed = Expression.parse(body, vocabulary)
                if (parsed is ExpressionError) return ExpressionError(text, parsed.from, parsed.until, parsed.kind, parsed.message)
                if ((parsed as Expression).type.isOverTime) {
                    val message = "“by ${signal.name}” needs one number for the whole log before it, as in max(x) by ${signal.name}."
                    return ExpressionError(text, 0, by, ExpressionErrorKind.TYPE, message)
                }
            }
            return ByState(body, signal, vocabulary)
        }

        private fun byTopic(text: String, body: String, keyFrom: Int, vocabulary: Vocabulary): ParsedQuestion {
            val quoted = PATTERN.find(body) ?: return ExpressionError(text, keyFrom, text.length, ExpressionErrorKind.SYNTAX, NO_PATTERN)
            val pattern = quoted.groupValues[1]
            val found = vocabulary.signals.filter { matches(it.name, pattern) || matches(it.name, "*/$pattern") }
            if (found.isEmpty()) {
                val message = "No topic matches “$pattern”; * matches anything, ? one character."
                return ExpressionError(text, quoted.range.first, quoted.range.last + 1, ExpressionErrorKind.UNKNOWN_TOPIC, message)
            }
            val parsed = found.map { signal ->
                val name = "\"${signal.name.replace("\"", "\"\"")}\""
                signal.name to Expression.parse(body.replace(quoted.value, name), vocabulary)
            }
            val parts = parsed.mapNotNull { (name, expression) -> (expression as? Expression)?.let { name to it } }
            if (parts.isNotEmpty()) return ByTopic(parts)
            return (parsed[0].second as ExpressionError).let { ExpressionError(it.text, it.from, it.until, it.kind, it.message) }
        }

        private fun each(text: String, vocabulary: Vocabulary): ParsedQuestion {
            val open = text.indexOf('(')
            val close = text.lastIndexOf(')')
            var from = open + 1
            val parts = ArrayList<Expression>()
            while (from <= close) {
                val comma = firstOutside(text, from, close, ',')
                // Spaces keep every position the same as in the whole text.
                val part = " ".repeat(from) + text.substring(from, comma)
                when (val parsed = Expression.parseAny(part, vocabulary)) {
                    is ExpressionError -> return ExpressionError(text, parsed.from, parsed.until, parsed.kind, parsed.message)
                    is Expression -> parts += parsed
                }
                from = comma + 1
            }
            val condition = parts.firstOrNull()
            if (condition == null || !condition.type.isCondition || !condition.type.isOverTime) {
                return ExpressionError(
                    text,
                    open + 1,
                    close,
                    ExpressionErrorKind.TYPE,
                    "each needs a condition that changes over time, such as x > 0.",
                )
            }
            return Each(condition, parts.drop(1))
        }

        private const val BY = " by "
        private const val CHANGED = "changed("
        private val FUNCTIONS_OF_STATE = setOf("total", "count")
        private val PATTERN = Regex("\"([^\"]*\\*[^\"]*)\"")
        private const val NO_PATTERN = "“by topic” needs a name with * in double quotes, as in max(\"PDP/Current *\") by topic."

        /** Returns [body] restricted to the time when [condition] holds. */
        private fun within(body: String, condition: String, vocabulary: Vocabulary): String {
            val whole = body.trim().lowercase()
            if (whole in FUNCTIONS_OF_STATE) return "$whole($condition)"
            val parsed = Expression.parse(body, vocabulary) as Expression
            val places = ArrayList<Node>()
            fun collect(node: Node) {
                if (node is Node.Call && node.arguments.firstOrNull()?.type?.isOverTime == true) {
                    places += node.arguments
                } else {
                    node.children.forEach(::collect)
                }
            }
            collect(parsed.root)
            return places.filter { it.type.isOverTime }.sortedByDescending { it.from }.fold(body) { text, node ->
                val operand = text.substring(node.from, node.until)
                val restricted = if (node.type.kind == Kind.CONDITION) "(($operand) and $condition)" else "(($operand) when $condition)"
                text.replaceRange(node.from, node.until, restricted)
            }
        }

        /** Returns the answers of [parts] as one answer. It has the number of each part that has one, or of each part that holds. */
        private fun grouped(parts: List<Pair<String, Expression>>, signals: Signals): Answer {
            val answers = parts.map { (group, expression) -> group to expression.answer(signals) }
            val outcomes = answers.map { it.second.outcome }
            val outcome = listOf(Outcome.NO_QUESTION, Outcome.HOLDS, Outcome.FAILS).firstOrNull { it in outcomes } ?: Outcome.UNKNOWN
            val decisive = answers.filter { (_, answer) -> answer.outcome == outcome && outcome != Outcome.FAILS }
            val quantities = decisive.mapNotNull { (group, answer) ->
                val quantity =
                    answer.quantities.firstOrNull() ?: Quantity("", answer.spans.sumOf { it.width }, signals.timeUnit, answer.time)
                quantity.copy(name = group).takeIf { !it.value.isNaN() }
            }
            val first = decisive.firstOrNull { it.second.spans.isNotEmpty() }?.second
            return Answer(
                outcome,
                if (outcome == Outcome.HOLDS) first?.spans.orEmpty() else emptyList(),
                if (outcome == Outcome.HOLDS) first?.times ?: 0 else 0,
                quantities,
                answers.firstOrNull()?.second?.timeUnit.orEmpty(),
                answers.firstNotNullOfOrNull { it.second.reason },
            )
        }

        /** Returns [value] just before [time]. */
        private fun textBefore(value: Value, time: Double, expression: Expression, signals: Signals): String {
            val unit = expression.unit(signals)
            if (value is Scalar) return Quantity("", value.value, unit, Double.NaN).text
            val column = value as Column
            var place = -1
            for (i in 0 until column.size) if (column.time(i) < time) place = i
            val number = if (place < 0) Double.NaN else column.y[place]
            if (number.isNaN()) return NOTHING
            if (expression.type.isCondition) return if (number == 1.0) "true" else "false"
            return column.texts?.get(number.toInt()) ?: Quantity("", number, unit, Double.NaN).text
        }

        private const val NOTHING = "no value"
    }
}

/** Returns the last index of [word] in [text] outside quotes and parentheses; -1 if there is none. */
private fun lastOutside(text: String, word: String): Int {
    var found = -1
    outside(text, 0, text.length) { if (text.startsWith(word, it, ignoreCase = true)) found = it }
    return found
}

/** Returns the first index of [character] in [text] from [from] on, outside quotes and parentheses; [until] if there is none. */
private fun firstOutside(text: String, from: Int, until: Int, character: Char): Int {
    var found = until
    outside(text, from, until) { if (found == until && text[it] == character) found = it }
    return found
}

private inline fun outside(text: String, from: Int, until: Int, visit: (Int) -> Unit) {
    var quote = ' '
    var depth = 0
    for (i in from until until) {
        val character = text[i]
        when {
            quote != ' ' -> if (character == quote) quote = ' '
            character in "'\"`" -> quote = character
            character == '(' -> depth++
            character == ')' -> depth--
            depth == 0 -> visit(i)
        }
    }
}
