package badlog.viewer

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic

/** A bag of [topics], each a name with attributes after bars; [rows] are its lines in the file. */
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
internal fun timedView(vararg topics: Topic): LogView = LogView.of(Recording(Records, null, emptyList(), topics.toList(), 0, emptyList()))

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

/** A format without rows. */
private object Records : RecordingFormat {
    override val id: String get() = "records"
    override val title: String get() = "log of records"
    override val endings: List<String> get() = emptyList()
    override val hasRows: Boolean get() = false
}
