package badlog.cli.recover

import badlog.cli.Failure
import badlog.file.readRecording
import badlog.recording.Recording
import badlog.recording.Topic
import java.nio.file.Path

/**
 * Reads [written] again, which was made of [recording], and makes sure that it is whole and holds as much.
 *
 * @throws Failure when it is not.
 */
internal fun requireSame(recording: Recording, written: Path) {
    val again = readRecording(written, keepSamples = false)
    val hasAll = again.rowCount == recording.rowCount && again.topics.map(::contentOf) == recording.topics.map(::contentOf)
    if (again.isSalvaged || !hasAll) {
        throw Failure(
            "$written was written but does not read as the same: a text in it looks like rows, or a name cannot stand in a " +
                "line of titles; compare it with badlog info.",
        )
    }
}

/** What its cells hold, however they are written. */
private fun contentOf(topic: Topic): List<Any> {
    val counts = topic.counts
    return listOf(topic.name, counts.numbers + counts.truthValues, counts.texts)
}
