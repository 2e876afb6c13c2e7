package badlog.report.rules

import badlog.expression.Expression
import badlog.expression.ExpressionError
import badlog.expression.ExpressionErrorKind
import badlog.expression.Signal
import badlog.expression.Vocabulary

/**
 * Rules made ready for all logs with the same vocabulary. Safe for several threads.
 *
 * @param timeTopic the topic of the x axis, or null.
 * @param hasClock whether x is time, though no topic tells it.
 */
internal class RuleProgram(
    rules: RuleSet,
    private val vocabulary: Vocabulary,
    private val timeTopic: String?,
    private val hasClock: Boolean,
) {
    /** What an expression comes to. */
    sealed interface Parsed

    /** An expression to evaluate, with the signals it names. */
    class Question(val expression: Expression, val named: Map<String, NamedSignal>, val topic: String?) : Parsed

    /** What a rule comes to: [questions] to ask, or why there are none. */
    class Step(val rule: Rule, val questions: List<Question>, val refusal: Refusal?)

    /**
     * @property message why, such as "no topic is called “Arm”".
     * @property mistake where the rule seems to be wrong, rather than not for this log, the place in the file of rules.
     */
    class Refusal(val message: String, val mistake: String? = null) : Parsed

    private val aliases: Map<String, NamedSignal>
    private val missing: List<Alias>

    init {
        val found = LinkedHashMap<String, NamedSignal>()
        val time = vocabulary.signals.find { it.name == timeTopic } ?: CLOCK
        found[TIME] = NamedSignal(TIME, time, 1.0, time.unit)
        missing = rules.aliases.filter { alias ->
            val signal = alias.find(vocabulary.signals)
            if (signal != null) found[alias.name] = signal
            signal == null
        }
        aliases = found
    }

    // With the topic in turn, which is the same to an expression as all of its kind and unit.
    private val vocabularies = HashMap<Signal, Vocabulary>()
    private val withAliases = vocabulary.with(aliases.values)

    /** In the order of the rules. */
    val steps: List<Step> = rules.rules.map(::stepOf)

    private fun stepOf(rule: Rule): Step {
        val each = rule.each ?: return step(rule, listOf(parsed(rule, aliases, withAliases, null)))
        val topics = vocabulary.signals.filter { it.name != timeTopic && each.takes(it) }
        if (topics.isEmpty()) return Step(rule, emptyList(), Refusal("no topic is called $each"))
        val parsedOf = topics.groupBy { it.copy(name = TOPIC) }.mapValues { (listed, alike) ->
            val named = aliases + (TOPIC to NamedSignal(TOPIC, alike[0], 1.0, listed.unit))
            parsed(rule, named, vocabularies.getOrPut(listed) { vocabulary.with(named.values) }, TOPIC)
        }
        return step(rule, topics.map { topic -> forTopic(parsedOf.getValue(topic.copy(name = TOPIC)), topic) })
    }

    private fun forTopic(parsed: Parsed, topic: Signal): Parsed = if (parsed !is Question) {
        parsed
    } else {
        Question(
            parsed.expression,
            parsed.named + (TOPIC to NamedSignal(TOPIC, topic, 1.0, topic.unit)),
            topic.name,
        )
    }

    private fun step(rule: Rule, parsed: List<Parsed>): Step {
        val questions = parsed.filterIsInstance<Question>()
        val refusals = parsed.filterIsInstance<Refusal>()
        // Some topics are numbers, others texts: a rule for each is meant for those that it fits.
        val refusal = refusals.firstOrNull { it.mistake != null } ?: refusals.firstOrNull().takeIf { questions.isEmpty() }
        return Step(rule, if (refusal == null) questions else emptyList(), refusal)
    }

    private fun parsed(rule: Rule, named: Map<String, NamedSignal>, vocabulary: Vocabulary, each: String?): Parsed =
        when (val parsed = Expression.parse(rule.condition, vocabulary)) {
            is ExpressionError -> refusal(rule, parsed, each != null)

            is Expression -> {
                val signals = parsed.topics.map { name -> named[name]?.signal to name }
                val topic = signals.firstOrNull()?.takeIf { it.first !== CLOCK }?.let { (signal, name) -> signal?.name ?: name }
                when {
                    !hasClock && signals.any { it.first === CLOCK } -> Refusal(NO_AXIS)
                    parsed.type.isCondition -> Question(parsed, named, topic)
                    else -> Refusal(NO_CONDITION, rule.place.pointed("This is a number; compare it, as in x < 7."))
                }
            }
        }

    private fun refusal(rule: Rule, error: ExpressionError, isForEach: Boolean): Refusal {
        val name = error.text.substring(error.from, error.until)
        return when (error.kind) {
            ExpressionErrorKind.UNKNOWN_TOPIC -> Refusal(whyMissing(name, error.message))

            ExpressionErrorKind.NO_TIME -> Refusal(if (timeTopic == null) NO_AXIS else "x of the log is no time")

            else -> {
                val reason = if (error.kind == ExpressionErrorKind.SYNTAX) NOT_ALL_THERE else error.message.trimEnd('.')
                val isOfTopic = isForEach && error.kind == ExpressionErrorKind.TYPE
                Refusal(reason, rule.place.pointed(error.message, error.from, error.until).takeIf { !isOfTopic })
            }
        }
    }

    private fun whyMissing(name: String, message: String): String {
        val alias = missing.find { name == it.name || name.startsWith("${it.name} ") } ?: return message.trimEnd('.')
        val unit = if (alias.unit == null) "" else " in ${alias.unit}"
        val others = if (alias.names.size > 1) " or so" else ""
        return "no topic for ${alias.name}, called “${alias.names[0].text}”$others$unit"
    }

    companion object {
        /** The name of each topic in turn, in a rule with `each`. */
        const val TOPIC = "topic"

        /** The x axis. */
        const val TIME = "time"
        private const val NO_AXIS = "the log has no x axis"
        private const val NO_CONDITION = "“when” is a number"

        // Where a name is missing, what is left of it may read as anything.
        private const val NOT_ALL_THERE = "not all topics of “when” are there"

        val RESERVED = setOf(TOPIC, TIME)
    }
}
