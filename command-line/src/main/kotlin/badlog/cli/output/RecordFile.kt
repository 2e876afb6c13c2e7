package badlog.cli.output

import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.files.terminal.Progress
import badlog.formats.wpilog.WpilogWriter
import badlog.formats.wpilog.record.RecordCopy
import badlog.formats.wpilog.record.RecordEntry
import badlog.formats.wpilog.record.RecordLog
import java.nio.file.Path

/**
 * Returns the records of [log], a WPILOG, inflated if necessary.
 *
 * @throws badlog.files.UnreadableFileException if it cannot be read.
 */
internal fun recordsOf(log: Path): RecordLog = RecordLog.Reader().run {
    inflate(log) { bytes, size -> accept(bytes, 0, size) }
    finish()
}

/** Returns the records of [recording] as a WPILOG, and the data that a WPILOG cannot hold. */
internal fun recordsOf(recording: Recording, changesOnly: Boolean = false): Pair<RecordLog, Omissions> = RecordLog.Reader().run {
    val omissions = WpilogWriter(recording, changesOnly).write { bytes, size -> accept(bytes, 0, size) }
    finish() to Omissions(omissions = omissions)
}

/** Creates [target] with the records of [log] that [copy] copies. Throws the same exceptions as [newLog]. */
internal fun <T> copyRecords(log: RecordLog, target: Path, progress: Progress, copy: RecordCopy.() -> T): T = newLog(target) { stream ->
    RecordCopy(log, progress::advanced) { bytes, size -> stream.write(bytes, 0, size) }.copy()
}

/** Returns the records of [log] that differ from the previous one of their entry. Returns all records of an entry if [isEvent]. */
internal fun changesOf(log: RecordLog, isEvent: (RecordEntry) -> Boolean): RecordLog = RecordLog.Reader().run {
    RecordCopy(log) { bytes, size -> accept(bytes, 0, size) }.changes(isEvent)
    finish()
}

/** Returns the topic of [entry] in this recording of its log; null if there is none, or several. */
internal fun Recording.topicOf(entry: RecordEntry): Topic? {
    if (entry.isValue) return null
    val alike = topics.filter { it.type == entry.type && it.name.startsWith(entry.name) }
    return alike.find { it.name == entry.name } ?: alike.find { it.name.removePrefix(entry.name).matches(NUMBERED) }
}

/** Returns whether the records of [entry] are events in this recording of its log. */
internal fun Recording.isEvent(entry: RecordEntry): Boolean =
    topicOf(entry)?.let { it.kind == TopicKind.EVENT || EVENT_LOG in it.attributes } == true

/** The attribute of events. */
internal const val EVENT_LOG = "log"

/** The suffix of a topic that has the same name as another one. */
private val NUMBERED = Regex(""" \(\d+\)""")
