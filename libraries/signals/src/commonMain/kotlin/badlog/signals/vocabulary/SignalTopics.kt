package badlog.signals.vocabulary

import badlog.core.analysis.FlagReading
import badlog.core.analysis.FlagTopic
import badlog.core.analysis.ModeTopics
import badlog.core.analysis.Units
import badlog.expression.signals.Signal
import badlog.expression.signals.Vocabulary

/**
 * A topic that was recognized as a signal.
 *
 * @property signal the signal.
 * @property topic the full name of the topic.
 * @property unit the unit in which rules and questions get its numbers; empty for none.
 * @property reason why it was recognized, and how its unit is known, as part of a sentence.
 * @property scale the factor that converts its numbers to [unit]; null if the samples decide whether they are percent or
 *   fractions.
 * @property device the part of its name that it shares with other topics of the same device.
 */
class SignalTopic internal constructor(
    val signal: String,
    internal val source: Signal,
    val unit: String,
    val reason: String,
    val scale: Double?,
    val device: String,
    internal val reading: FlagReading? = null,
    internal val atMost: Double? = null,
) {
    val topic: String get() = source.name
}

/**
 * Finds the signals of [vocabulary] among the topics of a log, by their [names].
 *
 * @param timeTopic the topic of the x axis, which cannot be another signal; null if there is none.
 * @param empty the names of topics without samples, which are not signals.
 */
class SignalTopics(
    private val vocabulary: SignalVocabulary,
    private val names: Vocabulary,
    private val timeTopic: String?,
    private val empty: Set<String> = emptySet(),
) {
    // With names that begin with a dot, WPILib's dashboards describe their topics.
    private val topics by lazy { names.signals.filter { it.name !in empty && "/." !in it.name }.map(::NamedTopic) }

    /** A topic, its name as patterns compare it, and the same without a unit at its end; null if it has none. */
    private inner class NamedTopic(val source: Signal) {
        val folded = NamePattern.folded(source.name)
        val unitless = vocabulary.withoutUnit(source.name).takeIf { it != source.name }
        private val foldedUnitless = unitless?.let(NamePattern::folded)

        fun fits(pattern: NamePattern): Boolean =
            pattern.matchesFolded(folded) || (foldedUnitless != null && pattern.matchesFolded(foldedUnitless))

        /** A topic with a unit in its name is a number, and no condition, whatever the rest says. */
        fun fits(pattern: NamePattern, content: SignalContent): Boolean =
            if (content == SignalContent.CONDITION) pattern.matchesFolded(folded) else fits(pattern)
    }

    private val found = HashMap<String, List<SignalTopic>>()

    /** All topics that were recognized as signals, in the order of the vocabulary. */
    val all: List<SignalTopic> get() = vocabulary.signals.flatMap { of(it.name) }

    /** Returns the topics of the signal [name]: at most one, unless the signal may have several. */
    fun of(name: String): List<SignalTopic> = found.getOrPut(name) { vocabulary.find(name)?.let(::search).orEmpty() }

    /** The topics that show when the robot was enabled. */
    val modes: ModeTopics by lazy {
        ModeTopics(flag(ROBOT_ENABLED), flag(ROBOT_AUTONOMOUS), flag(ROBOT_TEST), of(OP_MODE).firstOrNull()?.topic)
    }

    private fun flag(signal: String) = of(signal).firstOrNull()?.let { FlagTopic(it.topic, it.reading ?: FlagReading.Truth) }

    /** Returns the topics that add up to the signal [name], if it has no topic itself. */
    fun summandsOf(name: String): List<SignalTopic> = vocabulary.find(name)?.sumOf?.let(::of).orEmpty()

    /** Returns the pairs of [topics] with devices that a team has linked, each in both orders. */
    fun linked(topics: List<SignalTopic>): List<Pair<SignalTopic, SignalTopic>> = vocabulary.linked.flatMap { devices ->
        val members = topics.filter { topic -> devices.any { it.matches(topic.device) } }
        members.flatMap { one -> members.filter { it !== one }.map { one to it } }
    }

    private fun search(signal: SignalName): List<SignalTopic> {
        val taken = LinkedHashMap<String, SignalTopic>()
        for (pattern in signal.topics) {
            for (topic in topics) {
                val source = topic.source
                if (source.name == timeTopic || source.name in taken || !topic.fits(pattern.pattern, signal.content)) continue
                if (!pattern.fits(source.kind, signal.content) || signal.except.any { topic.fits(it) }) continue
                val named = if (pattern.pattern.matchesFolded(topic.folded)) source.name else topic.unitless.orEmpty()
                taken[source.name] = taken(signal, pattern, source, pattern.pattern.deviceIn(named)) ?: continue
                if (!signal.isMany) return taken.values.toList()
            }
        }
        return taken.values.toList()
    }

    private fun taken(signal: SignalName, pattern: TopicPattern, source: Signal, device: String): SignalTopic? {
        if (signal.content == SignalContent.CONDITION) {
            val how = pattern.unit?.let { ", read as “$it”" }.orEmpty()
            return SignalTopic(
                signal.name,
                source,
                unit = "",
                "fits “${pattern.pattern.text}”$how",
                scale = 1.0,
                device,
                pattern.reading.takeIf { pattern.unit != null },
            )
        }
        val wanted = signal.unit
        val named = if (Units.isNone(source.unit)) vocabulary.unitIn(source.name) else null
        val (unit, isKnownFrom) = when {
            !Units.isNone(source.unit) -> source.unit to "unit ${source.unit} in the log"
            pattern.unit != null -> pattern.unit to "${pattern.unit}, as such logs have it"
            named != null -> named.unit to "unit ${named.unit} in the name"
            wanted == PERCENT || wanted == FRACTION -> null to "percent or fraction by its samples"
            wanted == MILLISECONDS -> null to "s, ms or µs by its samples"
            wanted != null -> wanted to "taken to be in $wanted"
            else -> "" to ""
        }
        val scale = if (wanted == null || unit == null) 1.0.takeIf { unit != null } else unitScale(unit, wanted) ?: return null
        val reason = "fits “${pattern.pattern.text}”" + if (isKnownFrom.isEmpty()) "" else ", $isKnownFrom"
        return SignalTopic(signal.name, source, wanted ?: unit.orEmpty(), reason, scale, device, atMost = signal.atMost)
    }
}

private const val PERCENT = "%"
private const val MILLISECONDS = "ms"
