package badlog.catalog.folder

import badlog.catalog.examine.LogContent
import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.files.LogFile
import badlog.files.LogName
import badlog.files.ReadOptions
import badlog.files.ReadResult
import badlog.files.orNotRead
import badlog.files.readLog
import badlog.formats.LOG_FORMATS
import badlog.signals.overItsTime
import badlog.signals.withSignals
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.LogSummary
import java.util.concurrent.CancellationException

/**
 * Reads the logs of a folder, each once, and puts the results into [store]. It uses one core: other cores read other files or serve the
 * window.
 */
class LogReading(private val store: FolderStore) {
    /**
     * Reads [file]. Problems with the file become part of the result.
     *
     * @param runsRules whether the rules run over it as well, if it is not empty.
     * @param checkpoint called repeatedly; to cancel, it may throw a [CancellationException], the only exception that is passed on.
     * @param onSummary called with the result before the rules run.
     */
    fun read(file: LogFile, runsRules: Boolean, checkpoint: () -> Unit = {}, onSummary: (LogEntry) -> Unit = {}): LogEntry {
        val read = orNotRead(file.path, { Summarized(unreadable(file, it)) }) { summarized(file, checkpoint) }
        // An unreadable file may be readable later, with other permissions or more memory.
        if (read.isLasting) store[file] = read.summary
        val entry = LogEntry(file, read.summary)
        onSummary(entry)
        val log = read.log?.takeIf { runsRules && !entry.isGray } ?: return entry
        return entry.copy(found = store.rulesFor(file.path).found(file) ?: examined(file, log, checkpoint))
    }

    private class Summarized(val summary: LogSummary, val log: LogContent.Log? = null, val isLasting: Boolean = false)

    private fun summarized(file: LogFile, checkpoint: () -> Unit): Summarized {
        if (!isLikelyLog(file)) {
            val other = LogSummary.unreadable(file.name, file.modified, "${file.name} is not a log.", Content.NO_LOG)
            return Summarized(other, isLasting = true)
        }
        return when (val read = readLog(file.path, LOG_FORMATS, ReadOptions(cores = 1)) { _, _ -> checkpoint() }) {
            is ReadResult.Read -> {
                val view = viewOf(read.recording, file)
                Summarized(summaryOf(file, view), LogContent.Log(read.recording, view, emptyList()), isLasting = true)
            }

            is ReadResult.NotRead -> if (read.cause == ReadResult.Cause.TOO_LARGE) {
                Summarized(withoutSamples(file, checkpoint))
            } else {
                Summarized(unreadable(file, read), isLasting = read.isLasting)
            }
        }
    }

    /** Returns the findings of the rules in [file]: the stored ones; if there are none, the file is read again. */
    fun found(file: LogFile, checkpoint: () -> Unit = {}): FindingSummary {
        val rules = store.rulesFor(file.path)
        rules.found(file)?.let { return it }
        return orNotRead(file.path, { FindingSummary(rules.key, null) }) {
            when (val read = readLog(file.path, LOG_FORMATS, ReadOptions(cores = 1)) { _, _ -> checkpoint() }) {
                is ReadResult.NotRead -> FindingSummary(rules.key, null)

                is ReadResult.Read -> {
                    val log = LogContent.Log(read.recording, viewOf(read.recording, file), emptyList())
                    examined(file, log, checkpoint)
                }
            }
        }
    }

    private fun examined(file: LogFile, log: LogContent.Log, checkpoint: () -> Unit): FindingSummary {
        val rules = store.rulesFor(file.path)
        return orNotRead(file.path, { FindingSummary(rules.key, null) }) {
            val examined = atLowPriority { rules.examination.of(log, file.name, checkpoint) }.result
            rules.results?.set(file, examined)
            rules.foundIn(examined)
        }
    }

    private fun viewOf(recording: Recording, file: LogFile) =
        LogView.of(recording.overItsTime()).withSignals(store.rulesFor(file.path).rules.signals, file.name)

    private fun summaryOf(file: LogFile, view: LogView) =
        LogSummary.of(view, store.rulesFor(file.path).rules.signals, file.name, file.modified, LogName.of(file.name).isOnlyOfLogs)

    /** Returns the summary of a file with more samples than fit in memory. */
    private fun withoutSamples(file: LogFile, checkpoint: () -> Unit): LogSummary =
        when (val read = readLog(file.path, LOG_FORMATS, ReadOptions(keepSamples = false, cores = 1)) { _, _ -> checkpoint() }) {
            is ReadResult.NotRead -> unreadable(file, read)
            is ReadResult.Read -> summaryOf(file, viewOf(read.recording, file)).copy(content = Content.SOMETHING)
        }

    private fun unreadable(file: LogFile, why: ReadResult.NotRead): LogSummary {
        val isOther = why.cause == ReadResult.Cause.NO_LOG && !LogName.of(file.name).isOnlyOfLogs
        return LogSummary.unreadable(file.name, file.modified, why.message, if (isOther) Content.NO_LOG else Content.UNREADABLE)
    }
}

/** Does [work] with low priority. */
private inline fun <T> atLowPriority(work: () -> T): T {
    val thread = Thread.currentThread()
    val before = thread.priority
    thread.priority = Thread.MIN_PRIORITY
    try {
        return work()
    } finally {
        thread.priority = before
    }
}
