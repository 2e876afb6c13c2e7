package badlog.cli.merge

import badlog.cli.input.Failure
import badlog.cli.input.FileName
import badlog.cli.output.EVENT_LOG
import badlog.cli.topic.part
import badlog.cli.topic.with
import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import badlog.core.analysis.stableOrder
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.formats.wpilog.WpilogFormat
import java.nio.file.Path

/**
 * A log that becomes part of another.
 *
 * @property recording its content, at its times in the merge.
 * @property offset the delay of these times from the times in the file, in s.
 * @property isMatch whether the file is a ZIP or `match.json` of several logs.
 * @property isOfFile whether its samples are records of a WPILOG in the file.
 */
internal class LogPart(
    val file: Path,
    val recording: Recording,
    val offset: Double = 0.0,
    val isMatch: Boolean = false,
    val isOfFile: Boolean = recording.format.hasRecords && !isMatch,
) {
    val axis: XAxis = LogView.of(recording).xAxis
    private val topicOf = recording.topics.associateBy { it.name }

    /** Whether its samples are in rows, rather than at times of their own. */
    val hasRows: Boolean get() = recording.format.hasRows

    /** The folder for topics with names that are taken. */
    val folder: String get() = FileName.of(file).stem

    /** The topic of its x axis. Null if x is only the row's index, or the time of each sample. */
    val xTopic: Topic? get() = axis.topic

    /** The x of each row; may hold gaps. */
    val x: DoubleArray get() = axis.positions

    /** The first x; NaN if there is none. */
    val firstX: Double get() = (if (hasRows) x.firstOrNull { it.isFinite() } else axis.range?.start) ?: Double.NaN

    /** The last x; NaN if there is none. */
    val lastX: Double get() = (if (hasRows) x.lastOrNull { it.isFinite() } else axis.range?.endInclusive) ?: Double.NaN

    /** Returns the same log with another [recording], at the times of [offset]. */
    fun with(recording: Recording, offset: Double = this.offset) = LogPart(file, recording, offset, isMatch, isOfFile)

    /** Its topic [name], or null. */
    fun topic(name: String): Topic? = topicOf[name]
}

/**
 * Returns the same log without rows. Each topic has times of its own, in s, which replace the topic of x. Rows are sorted by x, which is
 * out of order if a clock was set. A row without x belongs to the previous row.
 *
 * @throws Failure if its x is not a time.
 */
internal fun LogPart.withOwnTimes(): LogPart {
    if (!hasRows) return if (isOfFile) this else LogPart(file, recording, isMatch = isMatch, isOfFile = false)
    val x = xTopic ?: throw Failure("$file has no x axis, so its rows cannot be placed; name the time topic with --x.")
    val seconds = Units.secondsIn(x.unit) ?: 1.0.takeIf { Units.isNone(x.unit) }
        ?: throw Failure("$file counts x in ${x.unit}, but a WPILOG in s; these are not one clock.")
    var last = Double.NaN
    val at = DoubleArray(x.size) { row -> this.x[row].let { if (it.isFinite()) it * seconds else last }.also { last = it } }
    val rows = stableOrder(at, at.indices.filter { !at[it].isNaN() }.toIntArray())
    val times = DoubleArray(rows.size) { at[rows[it]] }
    val topics = recording.topics.filter { it !== x }.map { topicAt(it, rows, times) }
    return LogPart(file, Recording(WpilogFormat, null, recording.values, topics, 0, recording.problems), isOfFile = false)
}

private fun topicAt(topic: Topic, rows: IntArray, times: DoubleArray): Topic {
    val isEvent = topic.kind == TopicKind.EVENT || EVENT_LOG in topic.attributes
    val described = if (isEvent && EVENT_LOG !in topic.attributes) topic.with(topic.attributes + EVENT_LOG) else topic
    val whole = described.part(rows, times)
    // A topic with times of its own has nothing between its samples, rather than gaps.
    if (!isEvent && !topic.isSparse) return whole
    val hasText = BooleanArray(rows.size).also { has -> whole.texts.rows.forEach { has[it] = true } }
    val kept = rows.indices.filter { hasText[it] || (whole.samples.isNotEmpty() && !whole.samples[it].isNaN()) }.toIntArray()
    return whole.part(kept, DoubleArray(kept.size) { times[kept[it]] })
}
