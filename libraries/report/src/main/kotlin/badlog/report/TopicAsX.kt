package badlog.report

import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.files.UnreadableFileException
import java.nio.file.Path

/** Thrown if a log does not have the requested topic. The message is one sentence for the user. */
class TopicException internal constructor(file: Path, message: String) : UnreadableFileException(file, message)

/** Returns this recording with the topic [name] as its x axis, unless it is null; see [withX]. */
internal fun Recording.withAnyX(name: String?, file: Path): Recording = if (name == null) this else withX(name, file)

/**
 * Returns this recording with the topic [name] as its x axis, which plain CSV does not name.
 *
 * @throws TopicException if it has no such topic, or has topics with times of their own; its message names [file], from
 * which it was read.
 */
fun Recording.withX(name: String, file: Path): Recording {
    if (!format.hasRows) {
        val reason = "$file is a ${format.title}, whose x axis is always the time; leave out --x, or convert it to a bag first."
        throw TopicException(file, reason)
    }
    val chosen = topicCalled(name, file) { "for the x axis" }
    return copy(topics = topics.map { it.asX(it === chosen) })
}

/**
 * Returns the topic of this recording called [name]: by its full name or, if that is unambiguous, regardless of case.
 *
 * @throws TopicException if there is none; its message names [file], from which this was read, and [purpose].
 */
fun Recording.topicCalled(name: String, file: Path, purpose: () -> String): Topic =
    topics.find { it.name == name } ?: topics.singleOrNull { it.name.equals(name, ignoreCase = true) }
        ?: throw TopicException(file, "$file has no topic “$name” ${purpose()}; its topics are ${listed(topics.map { it.name })}.")

private fun Topic.asX(isX: Boolean): Topic {
    if (isX == X_AXIS in attributes) return this
    return copy(attributes = if (isX) attributes + X_AXIS else attributes - X_AXIS)
}

private fun listed(names: List<String>) =
    if (names.isEmpty()) "none" else names.take(LISTED).joinToString() + if (names.size > LISTED) " and ${names.size - LISTED} more" else ""

private const val X_AXIS = "xaxis"
private const val LISTED = 5
