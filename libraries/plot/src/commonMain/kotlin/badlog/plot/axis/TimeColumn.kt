package badlog.plot.axis

import badlog.recording.PathName
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.Topic

/**
 * This recording with its column of the time as x axis where it is plain CSV, which names none: the first column called time or
 * timestamp, if it has a number in each row and never falls. Else the recording itself.
 */
public fun Recording.overItsTime(): Recording {
    if (format != RecordingFormat.CSV || topics.any { X_AXIS in it.attributes }) return this
    val time = topics.firstOrNull { TIME.matches(PathName.baseNameOf(it.name)) && rises(it) } ?: return this
    return copy(topics = topics.map { if (it === time) it.copy(attributes = it.attributes + X_AXIS) else it })
}

private fun rises(topic: Topic): Boolean {
    val samples = topic.samples
    return topic.times == null && samples.size > 1 && samples.all { it.isFinite() } && samples.first() < samples.last() &&
        (1 until samples.size).all { samples[it] >= samples[it - 1] }
}

private const val X_AXIS = "xaxis"

// With its unit or without: Time, Timestamp, time_s, Time (s). On Node only an anchor makes a pattern look for a longer match.
private val TIME = Regex("^(time|timestamp)([ _]?[(\\[]?(s|sec|seconds|ms)[)\\]]?)?$", RegexOption.IGNORE_CASE)
