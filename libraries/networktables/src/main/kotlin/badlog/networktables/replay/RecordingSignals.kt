package badlog.networktables.replay

import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import badlog.core.analysis.enabledSpans
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.core.text.UniqueNames
import badlog.networktables.TopicType

/**
 * Returns the topics of [view]'s recording as NetworkTables topics, then its values below `Values/`. A control word is added if the log
 * shows when the robot was enabled and no topic already says so in the form that dashboards know.
 *
 * @param logged the topics that are sent as logged; if there are any, only calculated topics of the recording, which have no type, are
 *   added.
 */
internal fun signalsOf(view: LogView, prefix: String, logged: List<LoggedTopic> = emptyList()): List<ReplayedTopic> {
    val names = TopicNames(prefix)
    val described = view.recording.topics.filter { logged.isEmpty() || it.type.isEmpty() }
    val signals = logged.map { signalOf(it, names.nameOf(it.name)) } +
        described.map { signalOf(it, view, names.nameOf(it.name)) } +
        view.recording.values.map { value ->
            // Before every position, so that the value is there from the start.
            val sample = Series(doubleArrayOf(Double.NEGATIVE_INFINITY), doubleArrayOf(0.0))
            val name = names.nameOf("Values/" + value.name.trimStart('/'))
            ReplayedTopic(name, TopicType.STRING, Topic.UNITLESS, sample, listOf(value.text.encodeToByteArray()))
        }
    val isKnown = signals.any { it.name.endsWith(CONTROL_WORD, ignoreCase = true) }
    return if (isKnown) signals else signals + listOfNotNull(controlWordOf(view))
}

private fun signalOf(topic: LoggedTopic, name: String): ReplayedTopic {
    val type = TopicType.of(topic.type)
    val typeName = if (type == TopicType.RAW || topic.type == "json") topic.type else type.typeName
    return ReplayedTopic(name, type, topic.unit, Series(topic.times, topic.times), typeName = typeName, payload = topic.payload)
}

/** Returns the robot's enabled state and mode as a control word, as a robot publishes it. Null if the log does not show them. */
private fun controlWordOf(view: LogView): ReplayedTopic? {
    val spans = view.enabledSpans()
    val start = view.xAxis.range?.start ?: return null
    if (spans.isEmpty()) return null
    val words = sortedMapOf(start to ATTACHED)
    for (enabled in spans) {
        val mode = when {
            enabled.isAutonomous -> AUTONOMOUS
            enabled.isTest -> TEST
            else -> 0
        }
        words[enabled.span.from] = ATTACHED or ENABLED or mode
        if (spans.none { it.span.from == enabled.span.to }) words[enabled.span.to] = ATTACHED
    }
    val samples = Series(words.keys.toDoubleArray(), DoubleArray(words.size) { words.values.elementAt(it).toDouble() })
    return ReplayedTopic("/FMSInfo$CONTROL_WORD", TopicType.INT, Topic.UNITLESS, samples)
}

private const val CONTROL_WORD = "/FMSControlData"
private const val ENABLED = 1
private const val AUTONOMOUS = 2
private const val TEST = 4

/** The Driver Station is connected. */
private const val ATTACHED = 32

private fun signalOf(topic: Topic, view: LogView, name: String): ReplayedTopic {
    if (topic.kind == TopicKind.EVENT || "log" in topic.attributes) return eventsOf(topic, view, name)
    val line = view.seriesOf(topic)
    val type = when {
        topic.kind == TopicKind.BOOLEAN -> TopicType.BOOLEAN
        line.states != null -> TopicType.STRING
        else -> TopicType.DOUBLE
    }
    val samples = line.data.ordered().withoutGaps(keepsFirst = type == TopicType.DOUBLE)
    val texts = if (type == TopicType.STRING) line.states.orEmpty().map { it.encodeToByteArray() } else emptyList()
    return ReplayedTopic(name, type, topic.unit, samples, texts)
}

private fun eventsOf(topic: Topic, view: LogView, name: String): ReplayedTopic {
    val events = view.eventsOf(topic).events
    val placed = events.indices.filter { events[it].x.isFinite() }
    val samples = Series(
        DoubleArray(placed.size) { events[placed[it]].x },
        DoubleArray(placed.size) { topic.texts.ids[placed[it]].toDouble() },
    )
    val texts = topic.texts.dictionary.map { it.encodeToByteArray() }
    return ReplayedTopic(name, TopicType.STRING, topic.unit, samples.ordered(), texts)
}

/** Returns the range from the earliest sample to the latest; 0 to 0 if there are none. */
internal fun rangeOf(signals: List<ReplayedTopic>): ClosedFloatingPointRange<Double> {
    val ranges = signals.mapNotNull { it.samples.range }.filter { it.start.isFinite() }
    return if (ranges.isEmpty()) 0.0..0.0 else ranges.minOf { it.start }..ranges.maxOf { it.endInclusive }
}

/**
 * The NetworkTables names of a recording's topics: `/Folder/Name`, each unique, and all below [prefix] if there is one. Only type
 * descriptions stay where dashboards look for them.
 */
internal class TopicNames(prefix: String) {
    private val start = prefix.trim('/').let { if (it.isEmpty()) "/" else "/$it/" }
    private val names = UniqueNames()

    /** Returns a unique name. Topics that a log took from NetworkTables, `NT:/…`, get their original names back. */
    fun nameOf(name: String): String {
        val bare = name.removePrefix("NT:").trimStart('/')
        return names.give(if (bare.startsWith(SCHEMAS)) "/$bare" else start + bare)
    }
}

/** Used for recordings without a time: robots usually log every 20 ms. */
private const val ROWS_PER_SECOND = 50.0

/** Returns the increase of [axis] per second. An x that is neither time nor index is treated as seconds. */
internal fun unitsPerSecond(axis: XAxis): Double = Units.secondsIn(axis.unit)?.let { 1 / it } ?: if (axis.isIndex) ROWS_PER_SECOND else 1.0

private const val SCHEMAS = ".schema/"
