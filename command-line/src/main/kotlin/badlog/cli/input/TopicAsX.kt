package badlog.cli.input

import badlog.cli.Failure
import badlog.cli.topic.with
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.Topic
import java.nio.file.Path

/**
 * This recording with the topic [name] as its x axis, which plain CSV does not tell.
 *
 * @throws Failure when it has no such topic, or topics with times of their own, with [file], from which it was read.
 */
internal fun Recording.withX(name: String, file: Path): Recording {
    if (format == RecordingFormat.WPILOG) {
        throw Failure("$file is a WPILOG, whose x axis is always the time; leave out --x, or convert it to a bag first.")
    }
    val chosen = topicCalled(name, file) { "to be the x axis" }
    return Recording(format, headerLine, values, topics.map { it.asX(it === chosen) }, rowCount, problems)
}

/**
 * The topic of this recording that is called [name]: known by its full name, and where that is the only one, by its name in
 * other cases of letters.
 *
 * @throws Failure when there is none, with [file], from which this was read, and [purpose].
 */
internal fun Recording.topicCalled(name: String, file: Path, purpose: () -> String): Topic =
    topics.find { it.name == name } ?: topics.singleOrNull { it.name.equals(name, ignoreCase = true) }
        ?: throw Failure("$file has no topic “$name” ${purpose()}; there are ${listed(topics.map { it.name })}.")

private fun Topic.asX(isX: Boolean): Topic {
    if (isX == X_AXIS in attributes) return this
    return with(if (isX) attributes + X_AXIS else attributes - X_AXIS)
}

private fun listed(names: List<String>) =
    if (names.isEmpty()) "none" else names.take(LISTED).joinToString() + if (names.size > LISTED) " and ${names.size - LISTED} more" else ""

private const val X_AXIS = "xaxis"
private const val LISTED = 5
