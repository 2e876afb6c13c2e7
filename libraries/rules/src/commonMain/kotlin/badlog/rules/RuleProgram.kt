package badlog.rules

import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.recording.Recording
import badlog.expression.Expression
import badlog.expression.ExpressionError
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import badlog.expression.syntax.ExpressionErrorKind
import badlog.signals.ACTIVE
import badlog.signals.ACTIVITY
import badlog.signals.CLOCK
import badlog.signals.DERIVED_NAMES
import badlog.signals.DEVIATION
import badlog.signals.LogShape
import badlog.signals.NamedSignal
import badlog.signals.PLAN_DISTANCE
import badlog.signals.SETTLED
import badlog.signals.SETTLEMENT
import badlog.signals.ScaledSignal
import badlog.signals.TIME
import badlog.signals.derived.busDeviceIn
import badlog.signals.derivedSignalsOf
import badlog.signals.kind.namesOfKind
import badlog.signals.kind.simulationIn
import badlog.signals.match.matchOf
import badlog.signals.vocabulary.NamePattern
import badlog.signals.vocabulary.SignalTopic
import kotlin.coroutines.cancellation.CancellationException

/**
 * The result of a rule for a log.
 *
 * @property rule the rule.
 * @property findings the findings of the rule; empty if it was skipped.
 * @property refusal why it was skipped; null if it was not.
 */
class RuleResult internal constructor(val rule: Rule, val findings: List<Finding>, val refusal: Refusal?)

/**
 * Why a rule is skipped for a log.
 *
 * @property message the reason, such as "no topic is called “Arm”".
 * @property mistake the message with its place in the file of rules, if the rule itself seems to be wrong; null if it merely does not suit
 *   this log.
 * @property lacking the signal that is missing in the log; null for another reason.
 * @property simulated why the log is considered simulated, if that is the reason; otherwise null.
 */
class Refusal internal constructor(
    val message: String,
    val mistake: String? = null,
    val lacking: String? = null,
    val simulated: String? = null,
) {
    /** Returns [rule] as skipped for this reason in [logs] logs. */
    fun of(rule: Rule, logs: Int): SkippedRule =
        SkippedRule(rule.name, logs, mistake ?: message, isMistake = mistake != null, rule.isBuiltIn, lacking, simulated)
}

/** [rules] prepared for all logs with an equal [shape]. Thread-safe. */
class RuleProgram(private val rules: RuleSet, private val shape: LogShape) {
    /** The result of parsing an expression. */
    internal sealed interface Parsed

    /** An expression to evaluate, with the signals it names. It is about [topic] and, for two linked topics, also about [other]. */
    internal class Question(
        val expression: Expression,
        val named: Map<String, NamedSignal>,
        val topic: String?,
        val isForEach: Boolean,
        val other: String?,
        val device: String,
        val evidence: List<String>,
        val channels: List<NamedSignal>,
        val others: List<NamedSignal> = emptyList(),
    ) : Parsed

    /** An expression that cannot be evaluated, with the reason. */
    internal class Refused(val refusal: Refusal) : Parsed

    /** A prepared rule: its [questions], or why there are none. */
    internal class Step(val rule: Rule, val questions: List<Question>, val refusal: Refusal?)

    /** The names that a rule has for the topics of one turn; [topic] is the first of them. */
    private class TopicBinding(val named: Map<String, NamedSignal>, val topic: String, val other: String? = null, val device: String = "")

    private val vocabulary get() = shape.vocabulary
    private val timeTopic get() = shape.timeTopic
    private val signals = shape.topicsOf(rules.signals)
    private val derived = derivedSignalsOf(shape, rules.signals, signals)
    private val time = (vocabulary.signals.find { it.name == timeTopic } ?: CLOCK).let { x ->
        // Without a unit, a time axis counts seconds.
        NamedSignal(TIME, listOf(ScaledSignal(x, 1.0)), if (vocabulary.hasTime && Units.isNone(x.unit)) "s" else x.unit)
    }

    // In built-in rules, the names of signals always mean signals; in others, they may be names of topics.
    private val named: Map<String, NamedSignal>
    private val namedOfTeam: Map<String, NamedSignal>
    private val absent: Map<String, Signal>
    private val missing: List<Alias>

    init {
        val found = LinkedHashMap<String, NamedSignal>()
        val lacking = LinkedHashMap<String, Signal>()
        for (signal in rules.signals.signals.filter { !it.isMany }) {
            val topics = signals.of(signal.name).ifEmpty { signals.summandsOf(signal.name) }
            if (topics.isEmpty()) {
                lacking[signal.name] = Signal(signal.name, signal.content.usualKind)
            } else {
                found[signal.name] = NamedSignal.of(signal.name, topics)
            }
        }
        if (rules.signals.find(PLAN_DISTANCE) == null) {
            val path = shape.path
            if (path == null) lacking[PLAN_DISTANCE] = DEVIATION else found[PLAN_DISTANCE] = NamedSignal.of(path)
        }
        for ((name, isSingle) in DERIVED_NAMES) {
            if (!isSingle || name in found) continue
            val own = derived.find { it.name == name }
            if (own == null) {
                if (rules.signals.find(name) == null) lacking[name] = Signal(name, SignalKind.NUMBER)
            } else {
                found[name] = NamedSignal.of(name, own)
                lacking -= name
            }
        }
        val aliases = LinkedHashMap<String, NamedSignal>()
        missing = rules.aliases.filter { alias ->
            val signal = alias.find(vocabulary.signals)
            if (signal != null) aliases[alias.name] = signal
            signal == null
        }
        named = mapOf(TIME to time, ACTIVE to NamedSignal.of(ACTIVE, ACTIVITY), SETTLED to NamedSignal.of(SETTLED, SETTLEMENT)) + found
        namedOfTeam = (mapOf(TIME to time) + found).filterKeys { !vocabulary.knows(it) } + (TIME to time) + aliases
        absent = lacking
    }

    // Vocabularies with the topics of a turn; all topics of the same kinds and units are equivalent for an expression.
    private val vocabularies = HashMap<List<Signal>, Vocabulary>()

    /** In the order of the rules. */
    private val steps: List<Step> = rules.rules.map(::stepOf)

    /**
     * The names of the topics that the rules need with their samples. The time, and the topics that show when the robot was enabled, are
     * not included.
     */
    val topics: Set<String> = steps.flatMap { it.questions }.flatMapTo(LinkedHashSet(), ::topicsOf) +
        namesOfKind(vocabulary.signals.map { it.name }) + signals.of("battery").map { it.topic }

    /**
     * Runs the rules on [view], which was read from a file called [file] and must have the program's shape. Each rule runs when the
     * sequence reaches it; the sequence can be iterated once. Rules for other types of match are omitted.
     *
     * @param isEverywhere whether findings have all their spans, with a text for each, for going through them one by one.
     */
    fun run(view: LogView, file: String, isEverywhere: Boolean = false): Sequence<RuleResult> {
        val match = rules.signals.matchOf(view.recording, file)
        val run = RuleRun(view.identified(match.title, signals.modes), file, rules.devices, isEverywhere)
        val type = match.type
        val simulated = simulationIn(view.recording, signals)
        val refusal = simulated?.let { Refusal("the robot was simulated: $it", simulated = it) }
        return steps.asSequence().filter { it.rule.isFor(type) }.map { step ->
            when {
                refusal != null && !step.rule.isForSimulations -> RuleResult(step.rule, emptyList(), refusal)
                !step.rule.needs.all(view.recording::has) -> RuleResult(step.rule, emptyList(), Refusal(IS_PART))
                else -> answerOf(step, run)
            }
        }
    }

    /** Returns the result of [step]; a rule that fails is skipped, so that the others' findings are kept. */
    private fun answerOf(step: Step, run: RuleRun): RuleResult = try {
        run.ask(step)
    } catch (e: CancellationException) {
        throw e
    } catch (e: RuntimeException) {
        val text = "It stopped, which is a mistake of badlog; report it with the log: $e."
        RuleResult(step.rule, emptyList(), Refusal(text, mistake = text))
    }

    /** Returns the rules that are skipped for [recording], each with the reason. [recording] was read from a file called [file]. */
    internal fun refusals(recording: Recording, file: String): List<Pair<Rule, Refusal>> {
        val type = rules.signals.matchOf(recording, file).type
        return steps.mapNotNull { step -> step.refusal?.takeIf { step.rule.isFor(type) }?.let { step.rule to it } }
    }

    private fun stepOf(rule: Rule): Step {
        val bindings = when (val each = rule.each) {
            null -> null
            is TopicsByName -> bindingsOf(each)
            is TopicsOfSignal -> bindingsOf(each)
        }
        if (bindings == null) return step(rule, listOf(parsed(rule, null)))
        if (bindings.isEmpty()) {
            return Step(rule, emptyList(), checkNotNull(rule.each).let { Refusal(noTopicText(it), lacking = lackingFor(it)) })
        }
        val parsedOf = HashMap<List<Signal>, Parsed>()
        return step(
            rule,
            bindings.map { binding ->
                val parsed = parsedOf.getOrPut(binding.named.values.map { it.listed }) { parsed(rule, binding) }
                if (parsed is Question) question(rule, parsed.expression, binding) else parsed
            },
        )
    }

    private fun bindingsOf(each: TopicsByName) = vocabulary.signals.filter { it.name != timeTopic && each.takes(it) }
        .map { TopicBinding(mapOf(TOPIC to NamedSignal.of(TOPIC, it)), it.name) }

    private fun bindingsOf(each: TopicsOfSignal): List<TopicBinding> {
        if (each.signal in DERIVED_NAMES) {
            return derived.filter { it.name == each.signal }.map { own ->
                TopicBinding(mapOf(TOPIC to NamedSignal.of(TOPIC, own)), own.topics.first(), device = own.device)
            }
        }
        // Devices that are named by ids send their values at different times. What they move decides what may stand still: signals that are
        // calculated know of both.
        val topics = signals.of(each.signal).filter { each.with.isEmpty() || each.hasIds || busDeviceIn(it.topic) == null }
        val pairs = if (each.isLinked) signals.linked(topics) else topics.map { it to null }
        return pairs.mapNotNull { (topic, other) ->
            val bound = linkedMapOf(TOPIC to NamedSignal.of(TOPIC, listOf(topic)))
            if (other != null) bound[OTHER] = NamedSignal.of(OTHER, listOf(other))
            for (name in each.with) bound[name] = NamedSignal.of(name, listOf(besides(topic, name) ?: return@mapNotNull null))
            TopicBinding(bound, topic.topic, other?.topic, topic.device)
        }
    }

    private fun besides(topic: SignalTopic, signal: String) =
        signals.of(signal).find { it.device.equals(topic.device, ignoreCase = true) && it.topic != topic.topic }

    private fun noTopicText(each: TopicChoice): String = when (each) {
        is TopicsByName -> "no topic matches $each"

        is TopicsOfSignal -> {
            val beside = if (each.with.isEmpty()) "" else " with ${each.with.joinToString(" and ") { "“$it”" }} of the same device"
            "no ${if (each.isLinked) "linked topics" else "topic"} for the signal “${each.signal}”$beside"
        }
    }

    /** Returns the first signal that [each] needs and the log lacks. Null for one that is calculated, since its name says little. */
    private fun lackingFor(each: TopicChoice): String? =
        (each as? TopicsOfSignal)?.let { listOf(it.signal) + it.with }?.find { it !in DERIVED_NAMES && signals.of(it).isEmpty() }

    private fun step(rule: Rule, parsed: List<Parsed>): Step {
        val questions = parsed.filterIsInstance<Question>()
        val refusals = parsed.filterIsInstance<Refused>().map { it.refusal }
        // Some topics are numbers, others texts: a rule with `each` is meant for those that it fits.
        val refusal = refusals.firstOrNull { it.mistake != null } ?: refusals.firstOrNull().takeIf { questions.isEmpty() }
        return Step(rule, if (refusal == null) questions else emptyList(), refusal)
    }

    private fun namesFor(rule: Rule, binding: TopicBinding?) = (if (rule.isBuiltIn) named else namedOfTeam) + binding?.named.orEmpty()

    private fun parsed(rule: Rule, binding: TopicBinding?): Parsed {
        val names = namesFor(rule, binding)
        val lacking = absent.values.filter { it.name !in names && (rule.isBuiltIn || !vocabulary.knows(it.name)) }
        val listed = names.values.map { it.listed } + lacking
        val known = vocabularies.getOrPut(listed) { Vocabulary(listed + vocabulary.signals, vocabulary.hasTime) }
        val expression = when (val parsed = Expression.parse(rule.condition, known)) {
            is Expression -> parsed
            is ExpressionError -> return Refused(refusal(rule, parsed, names, lacking))
        }
        val lacked = lacking.find { it.name in expression.topics }
        return when {
            lacked === DEVIATION -> Refused(Refusal(NO_PLAN))

            lacked != null ->
                Refused(Refusal("no topic for the signal “${lacked.name}”", lacking = lacked.name.takeIf { it !in DERIVED_NAMES }))

            expression.topics.any { names[it]?.only === CLOCK } && !shape.hasClock -> Refused(Refusal(NO_AXIS))

            expression.type.isCondition -> question(rule, expression, binding)

            fitsElsewhere(rule, names, lacking) -> Refused(Refusal(NO_CONDITION))

            else -> Refused(Refusal(NO_CONDITION, rule.place?.pointed("This is a number; compare it, as in x < 7.")))
        }
    }

    private fun question(rule: Rule, expression: Expression, binding: TopicBinding?): Question {
        val names = namesFor(rule, binding)
        val used = expression.topics.flatMap { names[it]?.topics ?: listOf(it) }
        val shown = rule.show.flatMap { names[it]?.topics ?: topicsCalled(it) }
        return Question(
            expression,
            names,
            binding?.topic ?: used.firstOrNull(),
            isForEach = binding != null,
            binding?.other,
            binding?.device.orEmpty(),
            (used + shown).filter { it != timeTopic }.distinct().take(MAX_EVIDENCE),
            if (rule.text.has(CHANNELS)) signals.of(CHANNEL).map { NamedSignal.of(CHANNEL, listOf(it)) } else emptyList(),
            if (rule.text.has(MEANWHILE)) {
                rule.show.flatMap { name -> signals.of(name).map { NamedSignal.of(name, listOf(it)) } }
            } else {
                emptyList()
            },
        )
    }

    /** Returns the topics of the signal [name], or those that match it as a pattern. */
    private fun topicsCalled(name: String): List<String> {
        if (rules.signals.find(name) != null) return signals.of(name).map { it.topic }
        val pattern = NamePattern(name)
        return vocabulary.signals.filter { pattern.matches(it.name) }.map { it.name }
    }

    private fun topicsOf(question: Question) = question.expression.topics.flatMap { question.named[it]?.topics ?: listOf(it) } +
        (question.channels + question.others).flatMap { it.topics }

    private fun refusal(rule: Rule, error: ExpressionError, names: Map<String, NamedSignal>, lacking: List<Signal>): Refusal {
        val name = error.text.substring(error.from, error.until)
        return when (error.kind) {
            ExpressionErrorKind.UNKNOWN_TOPIC -> Refusal(unknownTopicText(name, error.message))

            ExpressionErrorKind.NO_TIME -> Refusal(if (timeTopic == null) NO_AXIS else "the log's x axis is not a time")

            else -> {
                val reason = if (error.kind == ExpressionErrorKind.SYNTAX) NOT_ALL_THERE else error.message.trimEnd('.')
                val isForOthers = error.kind == ExpressionErrorKind.TYPE && fitsElsewhere(rule, names, lacking)
                Refusal(reason, rule.place?.pointed(error.message, error.from, error.until).takeIf { !isForOthers })
            }
        }
    }

    /**
     * Returns whether [rule] would be valid in a log in which the topics it names have suitable types. These are numbers, truth values or
     * texts.
     */
    private fun fitsElsewhere(rule: Rule, names: Map<String, NamedSignal>, lacking: List<Signal>) = SignalKind.entries.any { kind ->
        val others = names.values.map { if (it.name in ALWAYS) it.listed else it.listed.copy(kind = kind) }
        val parsed = Expression.parse(rule.condition, Vocabulary(others + lacking + vocabulary.signals, vocabulary.hasTime))
        parsed is Expression && parsed.type.isCondition
    }

    private fun unknownTopicText(name: String, message: String): String {
        val alias = missing.find { name == it.name || name.startsWith("${it.name} ") } ?: return message.trimEnd('.')
        val unit = if (alias.unit == null) "" else " in ${alias.unit}"
        return "no topic for ${alias.name}, matching “${alias.names[0].text}”$unit"
    }

    internal companion object {
        /** The name of the current topic in a rule with `each`. */
        const val TOPIC = "topic"

        /** The name of the second of two linked topics. */
        const val OTHER = "other"

        /** The placeholder in texts for the channels that drew most. */
        private const val CHANNELS = "channels"
        private const val CHANNEL = "channel current"

        /** The placeholder in texts for signals that the rule shows, and that were unusual while it held. */
        private const val MEANWHILE = "meanwhile"

        private const val IS_PART = "the file is only part of a log"
        private const val NO_AXIS = "the log has no x axis"
        private const val NO_PLAN = "no topics for the robot's pose and its planned pose"
        private const val NO_CONDITION = "“when” is a number"

        // If a name is missing, the rest of it may be read as anything.
        private const val NOT_ALL_THERE = "some topics of “when” are missing"

        /** Nobody can look at more graphs at once. */
        private const val MAX_EVIDENCE = 12

        val RESERVED = setOf(TOPIC, TIME, ACTIVE)

        /** What every log has a signal for. */
        private val ALWAYS = setOf(TIME, ACTIVE, SETTLED)
    }
}
