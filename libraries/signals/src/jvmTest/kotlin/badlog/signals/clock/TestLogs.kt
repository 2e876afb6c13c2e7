package badlog.signals.clock

import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet

/** A topic of numbers at times of their own. */
internal fun numbers(name: String, samples: List<Pair<Double, Double>>, unit: String = ""): Topic = topic(name, samples, unit, CellCounts(samples.size, 0, 0, 0, 0, 0))

/** A topic of truth values: false first, then the other way at each of [changes], until [end]. */
internal fun flag(name: String, begin: Double, changes: List<Double>, end: Double): Topic {
    val times = listOf(begin) + changes + end
    val samples = times.mapIndexed { i, time -> time to (if (i < times.size - 1) i % 2 else (i - 1) % 2).toDouble() }
    return topic(name, samples, "", CellCounts(0, 0, samples.size, 0, 0, 0))
}

private fun topic(name: String, samples: List<Pair<Double, Double>>, unit: String, counts: CellCounts) = Topic(
    name,
    unit,
    emptyList(),
    DoubleArray(samples.size) { samples[it].second },
    TextColumn.EMPTY,
    counts,
    DoubleArray(samples.size) { samples[it].first },
)

/** A log of [topics], which began at the time of day [start]. */
internal fun logOf(topics: List<Topic>, start: String? = null, values: List<Value> = emptyList()): Recording = Recording(Records, null, values + listOfNotNull(start?.let { Value("Start Time", it) }), topics, 0, emptyList())

internal fun clocked(recording: Recording, name: String = "log"): ClockedLog = ClockedLog(name, recording, RuleSet.BUILT_IN.signals)

/** A format without rows. */
private object Records : RecordingFormat {
    override val id: String get() = "records"
    override val title: String get() = "log of records"
    override val endings: List<String> get() = emptyList()
    override val hasRows: Boolean get() = false
}
