package badlog.cli.input

import badlog.cli.Failure
import badlog.recording.Recording
import badlog.recording.Topic
import java.nio.file.Path

/**
 * This recording with the topic [name] as its x axis, which plain CSV does not tell. A topic is
 * known by its full name, and where that is the only one, by its name in other cases of letters.
 *
 * @throws Failure when it has no such topic, with [file], from which it was read.
 */
internal fun Recording.withX(name: String, file: Path): Recording {
    val chosen = topics.find { it.name == name } ?: topics.singleOrNull { it.name.equals(name, ignoreCase = true) }
        ?: throw Failure("$file has no topic “$name” to be the x axis; there are ${listed(topics.map { it.name })}.")
    return Recording(format, headerLine, values, topics.map { it.asX(it === chosen) }, rowCount, problems)
}

private fun Topic.asX(isX: Boolean): Topic {
    if (isX == X_AXIS in attributes) return this
    val wanted = if (isX) attributes + X_AXIS else attributes - X_AXIS
    return Topic(name, unit, wanted, samples, texts, counts)
}

private fun listed(names: List<String>) =
    names.take(LISTED).joinToString() + if (names.size > LISTED) " and ${names.size - LISTED} more" else ""

private const val X_AXIS = "xaxis"
private const val LISTED = 5
