package badlog.expression

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.knowsAutonomous
import badlog.core.analysis.knowsEnabled
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.expression.samples.Stretches
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.expression.signals.Vocabulary

/** The topics of [view] as expressions see them. Not thread-safe. */
class LogViewSignals(private val view: LogView) : Signals {
    private val topics = view.recording.topics.associateBy { it.name }
    private val lines = HashMap<String, GraphSeries>()
    private val events = HashMap<String, Series>()

    override val vocabulary: Vocabulary =
        Vocabulary(view.recording.topics.map(::signalOf), view.xAxis.run { !isIndex && mayBeTime(unit) })

    override fun series(name: String): Series {
        val topic = topics.getValue(name)
        return if (kindOf(topic) == SignalKind.EVENT) events.getOrPut(name) { eventsOf(topic) } else lineOf(topic).data
    }

    override fun states(name: String): List<String> = topics.getValue(name).texts.dictionary

    override val enabled: List<EnabledSpan>? by lazy { if (view.knowsEnabled) view.enabledSpans() else null }

    override val knowsAutonomous: Boolean by lazy { view.knowsAutonomous }

    override val rows: DoubleArray? get() = view.xAxis.positions.takeIf { it.isNotEmpty() }

    override val axis: Series by lazy { axisOf(view.xAxis) }

    override val range: Span? by lazy { view.xAxis.range?.let { Span(it.start, it.endInclusive) } }

    override val timeUnit: String get() = view.xAxis.unit

    override val stretches: Stretches? by lazy { Stretches.of(view.xAxis.positions) }

    private fun lineOf(topic: Topic) = lines.getOrPut(topic.name) {
        view.seriesOf(topic).also { if (topic.isSparse) stretches?.keepRows(it.data.x, rowsWithNumber(topic)) }
    }

    private fun rowsWithNumber(topic: Topic) = topic.samples.indices.filter { isPlaced(it) && !topic.samples[it].isNaN() }

    private fun isPlaced(row: Int) = view.xAxis.positions.getOrElse(row) { Double.NaN }.isFinite()

    /** Returns only the texts, at their times. */
    private fun eventsOf(topic: Topic): Series {
        val texts = topic.texts
        val positions = topic.times ?: view.xAxis.positions
        val kept = (0 until texts.size).filter { positions.getOrElse(texts.rows[it]) { Double.NaN }.isFinite() }
        val x = DoubleArray(kept.size) { positions[texts.rows[kept[it]]] }
        if (topic.times == null) stretches?.keepRows(x, kept.map { texts.rows[it] })
        return Series(x, DoubleArray(kept.size) { texts.ids[kept[it]].toDouble() })
    }

    private fun axisOf(xAxis: XAxis): Series {
        val positions = xAxis.positions
        if (positions.isEmpty()) return clockOf(xAxis)
        if (positions.all { it.isFinite() }) return Series(positions, positions)
        return positions.filter { it.isFinite() }.toDoubleArray().let { Series(it, it) }
    }

    /** Returns every time at which a topic has a sample. */
    private fun clockOf(xAxis: XAxis): Series {
        val times = DoubleArray(xAxis.clocks.sumOf { it.size })
        var size = 0
        for (clock in xAxis.clocks) {
            clock.copyInto(times, size)
            size += clock.size
        }
        times.sort()
        var kept = 0
        for (time in times) if (kept == 0 || time > times[kept - 1]) times[kept++] = time
        return times.copyOf(kept).let { Series(it, it) }
    }

    private companion object {
        // Without a unit, an x other than the index is in seconds.
        fun mayBeTime(unit: String) = Units.isNone(unit) || Units.secondsIn(unit) != null
    }
}

/** Returns [topic] as expressions see it. */
fun signalOf(topic: Topic): Signal = Signal(topic.name, kindOf(topic), topic.unit)

private fun kindOf(topic: Topic) = when (topic.kind) {
    TopicKind.EMPTY, TopicKind.NUMERIC -> SignalKind.NUMBER
    TopicKind.BOOLEAN -> SignalKind.CONDITION
    TopicKind.STATE -> if ("log" in topic.attributes) SignalKind.EVENT else SignalKind.STATE
    TopicKind.EVENT -> SignalKind.EVENT
}
