package badlog.replay

import badlog.analysis.LogView
import badlog.analysis.Series
import badlog.analysis.Units
import badlog.analysis.XAxis
import badlog.recording.Topic
import badlog.recording.TopicKind
import badlog.text.UniqueNames

/** The topics of [view]'s recording, then its values below `Values/`, as NetworkTables shows them. */
internal fun signalsOf(view: LogView, prefix: String): List<Signal> {
    val names = TopicNames(prefix)
    return view.recording.topics.map { signalOf(it, view, names.nameOf(it.name)) } +
        view.recording.values.map { value ->
            // Before every position, so it holds from the start on.
            val sample = Series(doubleArrayOf(Double.NEGATIVE_INFINITY), doubleArrayOf(0.0))
            val name = names.nameOf("Values/" + value.name.trimStart('/'))
            Signal(name, SignalType.STRING, Topic.UNITLESS, sample, listOf(value.text.encodeToByteArray()))
        }
}

private fun signalOf(topic: Topic, view: LogView, name: String): Signal {
    if (topic.kind == TopicKind.EVENT || "log" in topic.attributes) return eventsOf(topic, view, name)
    val line = view.seriesOf(topic)
    val type = when {
        topic.kind == TopicKind.BOOLEAN -> SignalType.BOOLEAN
        line.states != null -> SignalType.STRING
        else -> SignalType.DOUBLE
    }
    val samples = line.data.ordered().withoutGaps(keepsFirst = type == SignalType.DOUBLE)
    val texts = if (type == SignalType.STRING) line.states.orEmpty().map { it.encodeToByteArray() } else emptyList()
    return Signal(name, type, topic.unit, samples, texts)
}

private fun eventsOf(topic: Topic, view: LogView, name: String): Signal {
    val events = view.eventsOf(topic).events
    val placed = events.indices.filter { events[it].x.isFinite() }
    val samples = Series(
        DoubleArray(placed.size) { events[placed[it]].x },
        DoubleArray(placed.size) { topic.texts.ids[placed[it]].toDouble() },
    )
    val texts = topic.texts.dictionary.map { it.encodeToByteArray() }
    return Signal(name, SignalType.STRING, topic.unit, samples.ordered(), texts)
}

/** From the first sample of all to the last; 0 to 0 without any. */
internal fun rangeOf(signals: List<Signal>): ClosedFloatingPointRange<Double> {
    val ranges = signals.mapNotNull { it.samples.range }.filter { it.start.isFinite() }
    return if (ranges.isEmpty()) 0.0..0.0 else ranges.minOf { it.start }..ranges.maxOf { it.endInclusive }
}

/** Names of a recording as NetworkTables has them: `/Folder/Name`, each once, all below [prefix] if there is one. */
internal class TopicNames(prefix: String) {
    private val start = prefix.trim('/').let { if (it.isEmpty()) "/" else "/$it/" }
    private val names = UniqueNames()

    /** A name that no other call gives. What a log took from NetworkTables, `NT:/…`, gets its name of then back. */
    fun nameOf(name: String): String = names.give(start + name.removePrefix("NT:").trimStart('/'))
}

/** A recording without a time is played as if its robot had logged every 20 ms, which is what robots do. */
private const val ROWS_PER_SECOND = 50.0

/** How far [axis] goes in a second. An x that is neither time nor index is taken for seconds. */
internal fun unitsPerSecond(axis: XAxis): Double = Units.secondsIn(axis.unit)?.let { 1 / it } ?: if (axis.isIndex) ROWS_PER_SECOND else 1.0
