package badlog.cli.output

import badlog.recording.Recording
import badlog.recording.Topic
import badlog.recording.TopicKind
import badlog.terminal.Progress
import badlog.wpilog.WpilogWriter
import badlog.wpilog.record.RecordCopy
import badlog.wpilog.record.RecordEntry
import badlog.wpilog.record.RecordLog
import java.nio.file.Path

/**
 * The records of [log], a WPILOG, inflated if need be.
 *
 * @throws badlog.file.UnreadableFileException when it cannot be read.
 */
internal fun recordsOf(log: Path): RecordLog = RecordLog.Reader().run {
    inflate(log) { bytes, size -> accept(bytes, 0, size) }
    finish()
}

/** The records that [recording] has as a WPILOG, and what that has no place for. */
internal fun recordsOf(recording: Recording, changesOnly: Boolean = false): Pair<RecordLog, Omissions> = RecordLog.Reader().run {
    val omissions = WpilogWriter(recording, changesOnly).write { bytes, size -> accept(bytes, 0, size) }
    finish() to Omissions(omissions = omissions)
}

/** Makes [target] of those records of [log] that [copy] copies. Errors as those of [newLog]. */
internal fun <T> copyRecords(log: RecordLog, target: Path, progress: Progress, copy: RecordCopy.() -> T): T = newLog(target) { stream ->
    RecordCopy(log, progress::advanced) { bytes, size -> stream.write(bytes, 0, size) }.copy()
}

/** Those records of [log] that are not the same as the one before them in their entry; all of an entry that [isEvent] says so of. */
internal fun changesOf(log: RecordLog, isEvent: (RecordEntry) -> Boolean): RecordLog = RecordLog.Reader().run {
    RecordCopy(log) { bytes, size -> accept(bytes, 0, size) }.changes(isEvent)
    finish()
}

/** The topic that [entry] is in this recording of its log; null where it is none, or several. */
internal fun Recording.topicOf(entry: RecordEntry): Topic? {
    if (entry.isValue) return null
    val alike = topics.filter { it.type == entry.type && it.name.startsWith(entry.name) }
    return alike.find { it.name == entry.name } ?: alike.find { it.name.removePrefix(entry.name).matches(NUMBERED) }
}

/** Whether the records of [entry] are events in this recording of its log. */
internal fun Recording.isEvent(entry: RecordEntry): Boolean =
    topicOf(entry)?.let { it.kind == TopicKind.EVENT || EVENT_LOG in it.attributes } == true

/** The attribute of what only happens. */
internal const val EVENT_LOG = "log"

/** What stands behind the name of a topic that another one has, too. */
private val NUMBERED = Regex(""" \(\d+\)""")
