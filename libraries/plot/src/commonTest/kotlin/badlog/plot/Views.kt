package badlog.plot

import badlog.analysis.LogView
import badlog.bag.BagParser
import badlog.recording.CellCounts
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.TextColumn
import badlog.recording.Topic

/** A bag of [topics], each a name with attributes after bars; [rows] as they are in the file. */
internal fun bagView(topics: List<String>, rows: List<String>): LogView {
    val header = topics.joinToString(",", """{"topics":[""", """],"values":[]}""") { topic ->
        val attributes = topic.split('|').drop(1).joinToString(",") { "\"$it\"" }
        """{"name":"${topic.substringBefore('|')}","unit":"V","attrs":[$attributes]}"""
    }
    val text = (listOf(header, topics.joinToString(",") { it.substringBefore('|') }) + rows).joinToString("\n", postfix = "\n")
    val parser = BagParser()
    parser.accept(text.encodeToByteArray())
    return LogView.of(parser.finish())
}

/** A log of [topics] with times of their own. */
internal fun timedView(vararg topics: Topic): LogView = LogView.of(Recording(RecordingFormat.WPILOG, null, emptyList(), topics.toList(), 0, emptyList()))

/** A topic of numbers with times of its own: each of [samples] a time and a number. */
internal fun timedTopic(name: String, vararg samples: Pair<Double, Double>): Topic = Topic(
    name,
    "V",
    emptyList(),
    DoubleArray(samples.size) { samples[it].second },
    TextColumn.EMPTY,
    CellCounts(samples.size, 0, 0, 0, 0, 0),
    DoubleArray(samples.size) { samples[it].first },
    "double",
)
