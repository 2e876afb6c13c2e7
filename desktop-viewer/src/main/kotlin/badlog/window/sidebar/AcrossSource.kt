package badlog.window.sidebar

import badlog.catalog.folder.LogEntry
import badlog.core.analysis.statistics
import badlog.core.recording.PathName
import badlog.signals.match.localSecondOf
import badlog.viewer.panel.folder.AcrossLog
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.search.Trait
import badlog.viewer.text.isoText
import badlog.window.log.DrawableTopic
import badlog.window.log.OpenRecording
import badlog.window.log.isFoundBy
import java.io.IOException
import java.nio.file.Files
import java.util.concurrent.TimeUnit

/**
 * The data for the table of statistics.
 *
 * @property topics the names of all selectable topics, by folder.
 * @property drawn the topics of the recordings on the screen, by name.
 * @property logsOf returns the statistics of the given topics in every recording; it takes a while: call it off the window's thread.
 */
internal class AcrossSource(
    val topics: List<String>,
    private val drawn: Map<String, DrawableTopic>,
    val logsOf: (topics: List<String>) -> List<AcrossLog>,
) {
    /**
     * Returns the [topics] that match [query]. May look through samples.
     *
     * @param found the names of the topics that a finding is about.
     */
    fun topicsFoundBy(query: Query, found: Set<String>): List<String> =
        topics.filter { name -> drawn[name]?.isFoundBy(query, found) ?: query.matches(name, KNOWN) }

    private companion object {
        /** The known trait of a topic in a log that is not open: it has numbers. */
        val KNOWN = setOf(Trait.NUMBER)
    }
}

/**
 * Returns the data for the table: all signals with numbers of the [drawn] recordings, and [known] rows of other logs. Those rows are
 * included only if [isOverAll]. A log that is both is included once.
 */
internal fun acrossSource(drawn: List<OpenRecording>, known: List<AcrossLog>, isOverAll: Boolean = true): AcrossSource {
    val knownByFile = known.associateBy { it.path }
    val drawnFiles = drawn.mapTo(HashSet()) { "${it.file}" }
    val others = if (isOverAll) known.filter { it.path !in drawnFiles } else emptyList()
    val topics = LinkedHashSet<String>()
    val signals = drawn.flatMap { it.signals }.filter { it.hasFigures }
    signals.mapTo(topics) { it.name }
    for (row in others) topics += row.statistics.keys
    // The first signal of a name belongs to the open log, like the findings.
    val byName = signals.asReversed().associateBy { it.name }
    return AcrossSource(topics.sortedBy { PathName.folderOf(it).lowercase() }, byName) { asked ->
        drawn.map { acrossLog(it, asked, knownByFile["${it.file}"]?.date ?: dateOf(it)) } + others
    }
}

/** Returns the statistics of those [topics] that [recording] has; [date] is the time when it was recorded. */
internal fun acrossLog(recording: OpenRecording, topics: List<String>, date: String): AcrossLog {
    val signals = topics.mapNotNull { recording.signal(it) }.filter { it.hasFigures }
    return AcrossLog(
        label = recording.label,
        date = date,
        path = "${recording.file}",
        statistics = signals.associate { it.name to it.line.statistics() },
        units = signals.associate { it.name to it.unit },
        xUnit = recording.view.xAxis.unit,
    )
}

/** Returns the time of the last change to the file of [recording]; empty if the file is gone. */
private fun dateOf(recording: OpenRecording): String = try {
    sortableText(localSecondOf(Files.getLastModifiedTime(recording.file).to(TimeUnit.SECONDS)))
} catch (_: IOException) {
    ""
}

/** Returns [second] of a clock on the wall as text that sorts by time: `2024-03-16 10:41`. [second] is in s since 1970 on that clock. */
private fun sortableText(second: Long): String = isoText(second).replace('T', ' ')

/** Returns a row for each of [logs], the newest first. It has the statistics that are known without reading the log again. */
internal fun acrossLogs(logs: List<LogEntry>): List<AcrossLog> =
    logs.filter { it.isReadable && it.summary.topics.isNotEmpty() }.sortedWith(NEWEST_FIRST).map { log ->
        AcrossLog(
            label = log.summary.match.title ?: log.fileName,
            date = sortableText(log.summary.date.second),
            path = "${log.file}",
            statistics = log.summary.topics.associate { it.name to it.statistics },
            units = log.summary.topics.associate { it.name to it.unit },
            xUnit = log.summary.xUnit,
        )
    }

private val NEWEST_FIRST = compareByDescending<LogEntry> { it.summary.date.second }.thenBy { it.file }
