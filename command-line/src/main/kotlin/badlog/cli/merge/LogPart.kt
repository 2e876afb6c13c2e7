package badlog.cli.merge

import badlog.analysis.LogView
import badlog.cli.output.FileName
import badlog.recording.Recording
import badlog.recording.Topic
import java.nio.file.Path

/** A log that becomes part of another. */
internal class LogPart(val file: Path, val recording: Recording) {
    private val axis = LogView.of(recording).xAxis
    private val topicOf = recording.topics.associateBy { it.name }

    /** The folder of topics whose names are taken. */
    val folder: String get() = FileName.of(file).stem

    /** The topic of its x axis, or null where x is but the row's index. */
    val xTopic: Topic? get() = axis.topic

    /** The x of each row; may hold gaps. */
    val x: DoubleArray get() = axis.positions

    /** The first x there is, NaN without any. */
    val firstX: Double get() = x.firstOrNull { it.isFinite() } ?: Double.NaN

    /** The last x there is, NaN without any. */
    val lastX: Double get() = x.lastOrNull { it.isFinite() } ?: Double.NaN

    /** Its topic [name], or null. */
    fun topic(name: String): Topic? = topicOf[name]
}
