package badlog.report

import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.Topic
import java.nio.file.Path

/** A log has not the topic that was asked for. The message is one sentence for a person. */
public class TopicException internal constructor(override val message: String) : Exception(message)

/**
 * This recording with the topic [name] as its x axis, which plain CSV does not name.
 *
 * @throws TopicException when it has no such topic, or topics with times of their own, with [file], from which it was read.
 */
public fun Recording.withX(name: String, file: Path): Recording {
    if (!format.hasRows) {
        val what = if (format == RecordingFormat.WPILOG) "a WPILOG" else "a Driver Station log"
        throw TopicException("$file is $what, whose x axis is always the time; leave out --x, or convert it to a bag first.")
    }
    val chosen = topicCalled(name, file) { "for the x axis" }
    return copy(topics = topics.map { it.asX(it === chosen) })
}

/**
 * The topic of this recording that is called [name]: known by its full name, and where that is the only one, by its name in
 * other cases of letters.
 *
 * @throws TopicException when there is none, with [file], from which this was read, and [purpose].
 */
public fun Recording.topicCalled(name: String, file: Path, purpose: () -> String): Topic =
    topics.find { it.name == name } ?: topics.singleOrNull { it.name.equals(name, ignoreCase = true) }
        ?: throw TopicException("$file has no topic “$name” ${purpose()}; its topics are ${listed(topics.map { it.name })}.")

private fun Topic.asX(isX: Boolean): Topic {
    if (isX == X_AXIS in attributes) return this
    return copy(attributes = if (isX) attributes + X_AXIS else attributes - X_AXIS)
}

private fun listed(names: List<String>) =
    if (names.isEmpty()) "none" else names.take(LISTED).joinToString() + if (names.size > LISTED) " and ${names.size - LISTED} more" else ""

private const val X_AXIS = "xaxis"
private const val LISTED = 5
