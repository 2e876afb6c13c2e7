package badlog.cli.merge

import badlog.analysis.LogView
import badlog.analysis.XAxis
import badlog.cli.output.FileName
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.Topic
import java.nio.file.Path

/** A log that becomes part of another. */
internal class LogPart(val file: Path, val recording: Recording) {
    /** Its x axis. */
    val axis: XAxis = LogView.of(recording).xAxis
    private val topicOf = recording.topics.associateBy { it.name }

    /** Whether its samples stand in rows, not at times of their own. */
    val hasRows: Boolean get() = recording.format != RecordingFormat.WPILOG

    /** The folder of topics whose names are taken. */
    val folder: String get() = FileName.of(file).stem

    /** The topic of its x axis, or null where x is but the row's index, or the time of each sample. */
    val xTopic: Topic? get() = axis.topic

    /** The x of each row; may hold gaps. */
    val x: DoubleArray get() = axis.positions

    /** The first x there is, NaN without any. */
    val firstX: Double get() = (if (hasRows) x.firstOrNull { it.isFinite() } else axis.range?.start) ?: Double.NaN

    /** The last x there is, NaN without any. */
    val lastX: Double get() = (if (hasRows) x.lastOrNull { it.isFinite() } else axis.range?.endInclusive) ?: Double.NaN

    /** Its topic [name], or null. */
    fun topic(name: String): Topic? = topicOf[name]
}
