package badlog.rules

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.expression.Answer
import badlog.expression.LogViewSignals
import badlog.expression.Quantity
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.rules.standing.Standing
import badlog.signals.NamedSamples
import badlog.signals.NamedSignals
import badlog.signals.derived.busDeviceIn
import badlog.signals.kind.NoSensors
import badlog.signals.vocabulary.FRACTION
import kotlin.math.abs
import kotlin.math.round

/**
 * Runs the rules of a program on [view], which was read from a file called [file].
 *
 * @param devices the team's names for its devices.
 * @param isEverywhere whether findings have all their spans, with a text for each.
 */
internal class RuleRun(view: LogView, private val file: String, private val devices: DeviceNames, private val isEverywhere: Boolean) {
    private val log = LogViewSignals(view)
    private val match = view.title ?: file
    private val names = log.vocabulary.signals.mapTo(HashSet()) { it.name }
    private val isTimed = log.vocabulary.hasTime
    private val samples = NamedSamples(log, view)
    private val noSensors = NoSensors(log)

    /** What each rule has found something in: devices of the CAN bus, or else topics. */
    private val found = HashMap<String, Set<String?>>()

    /** Returns the result of [step]. */
    fun ask(step: RuleProgram.Step): RuleResult {
        val rule = step.rule
        val known = rule.unless.flatMapTo(HashSet()) { found[it].orEmpty() }
        val isByName = rule.each is TopicsByName && rule.isBuiltIn
        val asked = if (isByName) step.questions.filter { it.topic.orEmpty() !in noSensors } else step.questions
        val all = asked.filter { known.isEmpty() || subjectOf(rule, it.topic) !in known }.flatMap { find(rule, it) }
        if (all.isNotEmpty()) found[rule.name] = all.mapTo(HashSet()) { subjectOf(rule, it.topic) }
        val findings = if (rule.isOncePerEvent && !rule.isForEachText) oncePerEvent(all) else all
        // A silent rule's findings still keep the rules quiet that follow from it.
        return RuleResult(rule, findings.filter { rule.standing != Standing.SILENT }, step.refusal)
    }

    /** Returns the first of those [findings] that are about the same event. */
    private fun oncePerEvent(findings: List<Finding>): List<Finding> {
        val kept = ArrayList<Finding>()
        for (finding in findings) if (finding.spans.isEmpty() || kept.none { isSameEvent(it, finding) }) kept += finding
        return kept
    }

    /** The elements of a list may be logged one after the other; another list is another controller's. */
    private fun isSameEvent(one: Finding, other: Finding): Boolean {
        if (one.spans == other.spans) return true
        val list = listNameOf(one) ?: return false
        return list == listNameOf(other) && other.spans.all { span -> one.spans.any { abs(it.from - span.from) <= SAME_EVENT } }
    }

    private fun listNameOf(finding: Finding) = finding.topic?.takeIf { it.endsWith(']') }?.substringBeforeLast('[')

    // A finding about a log's start or end is about the log.
    private fun subjectOf(rule: Rule, topic: String?) = if (rule.needs.isEmpty()) topic?.let(::busDeviceIn) ?: topic else null

    private fun find(rule: Rule, question: RuleProgram.Question): List<Finding> {
        val signals = NamedSignals(log, question.named, question.expression.vocabulary, samples)
        // Most rules find nothing in most logs, which the smallest and largest samples alone already show.
        if (!question.expression.mayHold(signals::bounds)) return emptyList()
        val answer = question.expression.answerIfHolds(signals) ?: return emptyList()
        val messages = messagesOf(question, signals)
        if (!rule.isForEachText || messages == null || answer.spans.isEmpty()) {
            val textAt = { time: Double -> messages?.at(time)?.first().orEmpty() }
            return listOf(finding(rule, question, answer, answer.spans, answer.times, textAt, signals))
        }
        val alike = LinkedHashMap<String, MutableList<Span>>()
        // Each of several messages at the same time has a finding of its own.
        for (span in answer.spans.distinctBy { it.from }) {
            messages.at(span.from).mapTo(LinkedHashSet(), ::withoutNumbers).forEach { alike.getOrPut(it, ::ArrayList) += span }
        }
        return alike.entries.take(MAX_TEXTS).map { (kind, spans) ->
            finding(rule, question, answer, spans, spans.size, { time -> messages.at(time).first { withoutNumbers(it) == kind } }, signals)
        }
    }

    /** Texts that differ only in their numbers count as the same. */
    private fun withoutNumbers(text: String) = text.map { if (it.isDigit()) '0' else it }.joinToString("")

    private fun finding(
        rule: Rule,
        question: RuleProgram.Question,
        answer: Answer,
        hits: List<Span>,
        times: Int,
        textAt: (time: Double) -> String,
        signals: Signals,
    ): Finding {
        val found = joinedHits(hits)
        // A statement about the whole recording holds from its start to its end.
        val whole = listOfNotNull(signals.range).takeIf { found.isEmpty() }
        val spans = whole ?: found
        val at = if (found.isEmpty()) answer.time else found[0].from
        val time = if (at.isNaN() && spans.isNotEmpty()) spans[0].from else at
        val texted = TextedRule(rule, question, match, file, answer.timeUnit, devices)
        val channels = largestChannels(question.channels, found, samples, signals.range?.to ?: Double.NaN)
        val meanwhile = unusualWithin(hits, question.others, samples)
        return Finding(
            rule.name,
            rule.severity,
            question.topic,
            texted.text(
                value = answer.quantities.firstOrNull()?.let(::textOf) ?: textAt(at),
                time = time,
                count = if (whole == null) times else whole.size,
                length = (whole ?: hits).sumOf { it.width },
                meanwhile = meanwhile.map(::textOf),
                channels = channels.map { "${it.topic} (${timeText(round(it.amperes * 10) / 10, "A")})" },
            ),
            at,
            found.take(if (isEverywhere) Finding.MAX_PLACES else Finding.MAX_SPANS),
            if (found.size < hits.size) found.size else times,
            answer.timeUnit,
            evidence = evidenceOf(question, channels),
            next = rule.next,
            caveats = caveatsOf(question),
            isForEach = question.isForEach,
            trust = rule.trust,
            meanwhile = meanwhile.map { it.signal },
            texts = if (isEverywhere && found.size > 1) textsOf(found.take(Finding.MAX_PLACES), answer, textAt, texted) else emptyList(),
        )
    }

    /** Returns the topics that show what [question] found. The [channels] with the highest currents represent the other channels. */
    private fun evidenceOf(question: RuleProgram.Question, channels: List<LargestChannel>): List<String> {
        if (channels.isEmpty()) return question.evidence
        val all = question.channels.flatMapTo(HashSet()) { it.topics }
        return (question.evidence.filter { it !in all } + channels.map { it.topic }).distinct()
    }

    /** Says what may be missing in the samples that [question] is about. */
    private fun caveatsOf(question: RuleProgram.Question): List<String> {
        val named = question.expression.topics.mapNotNull { question.named[it] }
        val topics = named.flatMap { it.topics }.distinct().filter { isTimed && it in names }
        val rare = topics.mapNotNull { topic -> stepOf(topic)?.let { topic to it } }.sortedByDescending { it.second }.take(MAX_CAVEATS)
        val rates = rare.map { (topic, seconds) ->
            "$topic is sampled every ${timeText(seconds * 1000, "ms")} here: what is shorter is not seen."
        }
        return rates + topics.mapNotNull { topic ->
            val count = samples.implausible[topic] ?: return@mapNotNull null
            "$count sample${if (count == 1) " of $topic is" else "s of $topic are"} left out: no robot has such values."
        }
    }

    /** Returns the usual time between two samples of [topic] in s, if it is long and regular. */
    private fun stepOf(topic: String): Double? = steps.getOrPut(topic) {
        val series = log.series(topic)
        val own = DoubleArray((series.size - 1).coerceIn(0, MAX_STEPS)) { series.x[it + 1] - series.x[it] }.apply { sort() }
        val step = if (own.size < MIN_STEPS) 0.0 else round(own[own.size / 2] * 1000) / 1000
        step.takeIf { it > LONG_STEP && own[own.size * 9 / 10] < 1.5 * it } ?: Double.NaN
    }.takeIf { it.isFinite() }

    private val steps = HashMap<String, Double>()

    private fun textsOf(spans: List<Span>, answer: Answer, textAt: (Double) -> String, texted: TextedRule): List<String> {
        val all = answer.quantities.firstOrNull()?.let(::textOf)
        val own = answer.firstQuantityOver(spans)
        return spans.mapIndexed { i, span ->
            val value = own[i]?.let(::textOf) ?: all ?: textAt(span.from)
            texted.text(value, span.from, count = 1, span.width)
        }
    }

    // A fraction is shown in percent, which needs no unit name.
    private fun textOf(quantity: Quantity): String {
        val (value, unit) = if (quantity.unit == FRACTION) PERCENT * quantity.value to "%" else quantity.value to quantity.unit
        return quantity.copy(value = roundedForText(value, unit), unit = unit).text
    }

    private fun textOf(event: Meanwhile): String {
        fun text(value: Double) = timeText(roundedForText(value, event.unit), event.unit)
        return "${event.title} rose to ${text(event.most)} from its usual ${text(event.usual)}"
    }

    /** Returns the messages of the first topic of [question] that has some, or null. */
    private fun messagesOf(question: RuleProgram.Question, signals: Signals): Messages? {
        val name = question.expression.topics.firstOrNull { topic ->
            val kind = signals.vocabulary.signals.first { it.name == topic }.kind
            kind == SignalKind.EVENT || kind == SignalKind.STATE
        }
        return name?.let { Messages(question, signals, it) }
    }
}

/** The maximum number of different texts of a topic that are listed for a rule. */
private const val MAX_TEXTS = 20
private const val PERCENT = 100.0

/** In seconds, the unit of nearly all logs. */
private const val SAME_EVENT = 1.0

private const val MAX_CAVEATS = 2
private const val MAX_STEPS = 2000
private const val MIN_STEPS = 20

/** A loop takes 0.02 s; topics that are sampled more rarely miss something, in s. */
private const val LONG_STEP = 0.045
