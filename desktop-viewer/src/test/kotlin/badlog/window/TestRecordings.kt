package badlog.window

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.formats.wpilog.WpilogParser
import badlog.formats.wpilog.WpilogWriter
import badlog.window.log.OpenRecording
import java.io.ByteArrayOutputStream
import java.nio.file.Path

/** The recording that [text] is as a bag, as if it were in a file called [name]. */
internal fun recordingOf(text: String, name: String = "test.bag"): OpenRecording {
    val bytes = text.encodeToByteArray()
    val parser = BagParser(bytes.size.toLong())
    parser.accept(bytes)
    return OpenRecording(Path.of(name).toAbsolutePath(), LogView.of(parser.finish()))
}

/** A bag of [topics], each a name with attributes behind bars, of which `Time` is x; [rows] as they stand in the file. */
internal fun bagOf(topics: List<String>, rows: List<String>, values: Map<String, String> = emptyMap()): String {
    val header = topics.joinToString(",", """{"topics":[""", "],") { topic ->
        val attributes = topic.split('|').drop(1).joinToString(",") { "\"$it\"" }
        """{"name":"${topic.substringBefore('|')}","unit":"V","attrs":[$attributes]}"""
    } + values.entries.joinToString(",", "\"values\":[", "]}") { (name, value) -> """{"name":"$name","value":"$value"}""" }
    return (listOf(header, topics.joinToString(",") { it.substringBefore('|') }) + rows).joinToString("\n", postfix = "\n")
}

/** A topic of numbers as a WPILOG has it: each of [samples] a time in s and what was logged then. */
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

/** A topic of texts likewise. */
internal fun loggedTexts(name: String, vararg samples: Pair<Double, String>): Topic {
    val texts = samples.map { it.second }.distinct()
    val column = TextColumn(IntArray(samples.size) { it }, IntArray(samples.size) { texts.indexOf(samples[it].second) }, texts)
    val counts = CellCounts(0, 0, 0, samples.size, 0, 1)
    return Topic(name, Topic.UNITLESS, emptyList(), DoubleArray(0), column, counts, DoubleArray(samples.size) { samples[it].first }, "string")
}

/** The bytes of a WPILOG of [topics] and [values]. */
internal fun wpilogOf(topics: List<Topic>, values: List<Value> = emptyList()): ByteArray {
    val out = ByteArrayOutputStream()
    WpilogWriter(Recording(RecordingFormat.WPILOG, null, values, topics, 0, emptyList())).write { bytes, size -> out.write(bytes, 0, size) }
    return out.toByteArray()
}

/** The recording of a WPILOG of [topics]. */
internal fun wpilogRecording(vararg topics: Topic): OpenRecording {
    val parser = WpilogParser()
    parser.accept(wpilogOf(topics.toList()))
    return OpenRecording(Path.of("test.wpilog").toAbsolutePath(), LogView.of(parser.finish()))
}
