package badlog.signals

import badlog.core.recording.PathName
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Topic

/**
 * Returns the time column of a recording that names no x axis. It is the first one called time or timestamp, if it has a number in each row
 * and falls in at most 1 % of the rows. Null if there is none, or if the recording has an x axis.
 */
fun Recording.timeColumn(): Topic? {
    if (rowCount == 0 || topics.any { X_AXIS in it.attributes }) return null
    return topics.firstOrNull { TIME_NAME.matches(PathName.baseNameOf(it.name)) && rises(it) }
}

/** Returns the number of rows in which [column] is less than in the row before. It falls when the robot's clock is set. */
fun fallsOf(column: Topic): Int = column.samples.run { (1 until size).count { this[it] < this[it - 1] } }

/** Returns this recording with [column], one of its topics, as its x axis. */
fun Recording.over(column: Topic): Recording =
    copy(topics = topics.map { if (it === column) it.copy(attributes = it.attributes + X_AXIS) else it })

/**
 * Returns this recording with its [timeColumn] as x axis if it is plain CSV and has one. Otherwise returns the recording itself. Plain CSV
 * cannot name an x axis.
 */
fun Recording.overItsTime(): Recording = (if (format == RecordingFormat.CSV) timeColumn() else null)?.let(::over) ?: this

private fun rises(topic: Topic): Boolean {
    val samples = topic.samples
    val hasNumbers = topic.times == null && samples.size > 1 && samples.all { it.isFinite() }
    return hasNumbers && samples.first() < samples.last() && fallsOf(topic) <= samples.size * MAX_FALLS
}

/** The largest share of rows in which a time may fall. */
private const val MAX_FALLS = 0.01

private const val X_AXIS = "xaxis"

// With its unit or without: Time, Timestamp, time_s, Time (s). On Node, a pattern looks for a longer match only if it has an anchor.
private val TIME_NAME = Regex("^(time|timestamp)([ _]?[(\\[]?(s|sec|seconds|ms)[)\\]]?)?$", RegexOption.IGNORE_CASE)
