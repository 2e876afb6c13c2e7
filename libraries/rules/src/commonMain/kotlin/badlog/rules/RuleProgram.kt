package badlog.rules

import badlog.analysis.LogView
import badlog.expression.Expression
import badlog.expression.ExpressionError
import badlog.expression.LogViewSignals
import badlog.expression.signals.Signal
import badlog.expression.signals.Vocabulary
import badlog.expression.syntax.ExpressionErrorKind
import badlog.recording.PathName
import badlog.recording.Value

/**
 * What decides how rules are asked of a log. Logs of an equal shape share a [RuleProgram].
 *
 * @property vocabulary the names of the topics.
 * @property timeTopic the topic of the x axis, or null.
 * @property hasClock whether x is time, though no topic has it.
 */
public data class LogShape(public val vocabulary: Vocabulary, public val timeTopic: String?, public val hasClock: Boolean) {
    public companion object {
        /** The shape of [view], which needs no samples for it. */
        public fun of(view: LogView): LogShape {
            val x = view.xAxis
            return LogShape(LogViewSignals(view).vocabulary, x.topic?.name, hasClock = x.topic == null && !x.isIndex)
        }
    }
}

/**
 * What came of asking a rule of a log.
 *
 * @property rule the rule.
 * @property findings what it found; empty when it was refused.
 * @property refusal why it could not be asked; null when it was.
 */
public class AskedRule internal constructor(public val rule: Rule, public val findings: List<Finding>, public val refusal: Refusal?)

/**
 * Why a rule cannot be asked of a log.
 *
 * @property message why, such as "no topic is called “Arm”".
 * @property mistake where the rule seems to be wrong, rather than not for this log, the place in the file of rules; else null.
 */
public class Refusal internal constructor(public val message: String, public val mistake: String? = null) {
    /** [rule] as one that was skipped for so many [logs] by this. */
    public fun of(rule: Rule, logs: Int): SkippedRule = SkippedRule(rule.name, logs, mistake ?: message, isMistake = mistake != null)
}

/** [rules] made ready for all logs of an equal [shape]. Safe for several threads. */
public class RuleProgram(rules: RuleSet, private val shape: LogShape) {
    /** What an expression comes to. */
    internal sealed interface Parsed

    /** An expression to evaluate, with the signals it names. */
    internal class Question(val expression: Expression, val named: Map<String, NamedSignal>, val topic: String?) : Parsed

    /** Why an expression cannot be evaluated. */
    internal class Refused(val refusal: Refusal) : Parsed

    /** What a rule comes to: [questions] to ask, or why there are none. */
    internal class Step(val rule: Rule, val questions: List<Question>, val refusal: Refusal?)

    private val vocabulary get() = shape.vocabulary
    private val timeTopic get() = shape.timeTopic
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
    private val steps: List<Step> = rules.rules.map(::stepOf)

    /** The names of the topics whose samples the rules look at, beside those of the time and of when the robot was enabled. */
    public val topics: Set<String> = steps.flatMap { it.questions }.flatMapTo(LinkedHashSet()) { question ->
        question.expression.topics.map { question.named[it]?.signal?.name ?: it }
    }

    /**
     * Asks the rules of [view], which was read from a file called [file] and is of the program's shape: each when its turn
     * comes in the sequence, which may be gone through once. Those for other types of match are left out.
     */
    public fun run(view: LogView, file: String): Sequence<AskedRule> {
        val run = RuleRun(view, file)
        val type = matchType(view.recording.values)
        return steps.asSequence().filter { it.rule.isFor(type) }.map(run::ask)
    }

    /** The rules that cannot be asked of a log with these [values], and why. */
    internal fun refusals(values: List<Value>): List<Pair<Rule, Refusal>> {
        val type = matchType(values)
        return steps.mapNotNull { step -> step.refusal?.takeIf { step.rule.isFor(type) }?.let { step.rule to it } }
    }

    private fun stepOf(rule: Rule): Step {
        val each = rule.each ?: return step(rule, listOf(parsed(rule, aliases, withAliases, null)))
        val topics = vocabulary.signals.filter { it.name != timeTopic && each.takes(it) }
        if (topics.isEmpty()) return Step(rule, emptyList(), Refusal("no topic matches $each"))
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
        val refusals = parsed.filterIsInstance<Refused>().map { it.refusal }
        // Some topics are numbers, others texts: a rule for each is meant for those that it fits.
        val refusal = refusals.firstOrNull { it.mistake != null } ?: refusals.firstOrNull().takeIf { questions.isEmpty() }
        return Step(rule, if (refusal == null) questions else emptyList(), refusal)
    }

    private fun parsed(rule: Rule, named: Map<String, NamedSignal>, vocabulary: Vocabulary, each: String?): Parsed =
        when (val parsed = Expression.parse(rule.condition, vocabulary)) {
            is ExpressionError -> Refused(refusal(rule, parsed, each != null))

            is Expression -> {
                val signals = parsed.topics.map { name -> named[name]?.signal to name }
                val topic = signals.firstOrNull()?.takeIf { it.first !== CLOCK }?.let { (signal, name) -> signal?.name ?: name }
                when {
                    !shape.hasClock && signals.any { it.first === CLOCK } -> Refused(Refusal(NO_AXIS))
                    parsed.type.isCondition -> Question(parsed, named, topic)
                    else -> Refused(Refusal(NO_CONDITION, rule.place.pointed("This is a number; compare it, as in x < 7.")))
                }
            }
        }

    private fun refusal(rule: Rule, error: ExpressionError, isForEach: Boolean): Refusal {
        val name = error.text.substring(error.from, error.until)
        return when (error.kind) {
            ExpressionErrorKind.UNKNOWN_TOPIC -> Refusal(whyMissing(name, error.message))

            ExpressionErrorKind.NO_TIME -> Refusal(if (timeTopic == null) NO_AXIS else "x of the log is not a time")

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
        return "no topic for ${alias.name}, matching “${alias.names[0].text}”$unit"
    }

    internal companion object {
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

/** The type of the match in [values], such as `Qualification`. */
private fun matchType(values: List<Value>): String? = values
    .firstOrNull { PathName.baseNameOf(it.name).replace('_', ' ').lowercase() == "match type" && it.text.isNotBlank() }
    ?.text?.trim()
