package badlog.catalog.folder

import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.formats.wpilog.WpilogFormat
import badlog.formats.wpilog.WpilogWriter
import java.io.ByteArrayOutputStream

/** Returns a WPILOG topic of numbers; each of [samples] is a time in s and a value. */
internal fun loggedTopic(name: String, vararg samples: Pair<Double, Double>, unit: String = "V"): Topic = Topic(
    name,
    unit,
    emptyList(),
    DoubleArray(samples.size) { samples[it].second },
    TextColumn.EMPTY,
    CellCounts(samples.size, 0, 0, 0, 0, 0),
    DoubleArray(samples.size) { samples[it].first },
    "double",
)

/** Returns a WPILOG topic of texts, likewise. */
internal fun loggedTexts(name: String, vararg samples: Pair<Double, String>): Topic {
    val texts = samples.map { it.second }.distinct()
    val column = TextColumn(IntArray(samples.size) { it }, IntArray(samples.size) { texts.indexOf(samples[it].second) }, texts)
    val counts = CellCounts(0, 0, 0, samples.size, 0, 1)
    return Topic(name, Topic.UNITLESS, emptyList(), DoubleArray(0), column, counts, DoubleArray(samples.size) { samples[it].first }, "string")
}

/** Returns the bytes of a WPILOG with [topics] and [values]. */
internal fun wpilogOf(topics: List<Topic>, values: List<Value> = emptyList()): ByteArray {
    val out = ByteArrayOutputStream()
    WpilogWriter(Recording(WpilogFormat, null, values, topics, 0, emptyList())).write { bytes, size -> out.write(bytes, 0, size) }
    return out.toByteArray()
}
