package badlog.window.sidebar

import badlog.catalog.folder.LogEntry
import badlog.core.analysis.statistics
import badlog.core.recording.PathName
import badlog.signals.match.localSecondOf
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
 * What the table of statistics is made from.
 *
 * @property topics the names of all selectable topics, by folder.
 * @property drawn those topics that a recording on the screen has, by name.
 * @property rowsOf returns the statistics of some of them in every recording; it takes a while, so do not use it on the
 * window's thread.
 */
internal class StatisticsSource(
    val topics: List<String>,
    private val drawn: Map<String, DrawableTopic>,
    val rowsOf: (topics: List<String>) -> List<StatisticsRow>,
) {
    /** Those of [topics] that [query] finds; [found] are the names of those that a finding is about. May look through samples. */
    fun topicsFoundBy(query: Query, found: Set<String>): List<String> =
        topics.filter { name -> drawn[name]?.isFoundBy(query, found) ?: query.matches(name, KNOWN) }

    private companion object {
        /** What is known about a topic of a log that is not open: that it has numbers. */
        val KNOWN = setOf(Trait.NUMBER)
    }
}

/**
 * Returns what the table is made from: the recordings that are [drawn], of which every signal has figures, and if it [isOverAll]
 * the logs that are [known], with those figures that they came with. A log that is both is there once.
 */
internal fun statisticsSource(drawn: List<OpenRecording>, known: List<StatisticsRow>, isOverAll: Boolean = true): StatisticsSource {
    val knownByFile = known.associateBy { it.path }
    val drawnFiles = drawn.mapTo(HashSet()) { it.file }
    val others = if (isOverAll) known.filter { it.path !in drawnFiles } else emptyList()
    val topics = LinkedHashSet<String>()
    val signals = drawn.flatMap { it.signals }.filter { it.hasFigures }
    signals.mapTo(topics) { it.name }
    for (row in others) topics += row.statistics.keys
    // The first of one name is that of the open log, which the findings are of.
    val byName = signals.asReversed().associateBy { it.name }
    return StatisticsSource(topics.sortedBy { PathName.folderOf(it).lowercase() }, byName) { asked ->
        drawn.map { statisticsRow(it, asked, knownByFile[it.file]?.date ?: dateOf(it)) } + others
    }
}

/** Returns the figures of [topics] in [recording], those that it has; [date] is when it was recorded. */
internal fun statisticsRow(recording: OpenRecording, topics: List<String>, date: String): StatisticsRow {
    val signals = topics.mapNotNull { recording.signal(it) }.filter { it.hasFigures }
    return StatisticsRow(
        label = recording.label,
        date = date,
        path = recording.file,
        statistics = signals.associate { it.name to it.line.statistics() },
        units = signals.associate { it.name to it.unit },
        xUnit = recording.view.xAxis.unit,
    )
}

/** Returns when the file of [recording] was written last; empty when it is not there any more. */
private fun dateOf(recording: OpenRecording): String = try {
    sortableText(localSecondOf(Files.getLastModifiedTime(recording.file).to(TimeUnit.SECONDS)))
} catch (_: IOException) {
    ""
}

/** Returns [second] of a clock on the wall, in s since 1970 on that clock, as text that sorts by time: `2024-03-16 10:41`. */
private fun sortableText(second: Long): String = isoText(second).replace('T', ' ')

/** Returns each of [logs], the newest first, with the statistics of all its topics that are known without reading it again. */
internal fun rowsOf(logs: List<LogEntry>): List<StatisticsRow> =
    logs.filter { it.isReadable && it.summary.topics.isNotEmpty() }.sortedWith(NEWEST_FIRST).map { log ->
        StatisticsRow(
            label = log.summary.match.title ?: log.fileName,
            date = sortableText(log.summary.date.second),
            path = log.file,
            statistics = log.summary.topics.associate { it.name to it.statistics },
            units = log.summary.topics.associate { it.name to it.unit },
            xUnit = log.summary.xUnit,
        )
    }

private val NEWEST_FIRST = compareByDescending<LogEntry> { it.summary.date.second }.thenBy { it.file }
