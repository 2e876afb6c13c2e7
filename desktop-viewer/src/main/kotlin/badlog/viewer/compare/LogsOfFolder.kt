package badlog.viewer.compare

import badlog.viewer.library.index.LogEntry

/** Each of [logs], the newest first, with the figures of all its topics that are known without reading it again. */
internal fun rowsOf(logs: List<LogEntry>): List<StatisticsRow> =
    logs.filter { it.isReadable && it.topics.isNotEmpty() }.sortedWith(NEWEST_FIRST).map { log ->
        StatisticsRow(
            label = log.title,
            date = sortableText(log.date.time),
            path = log.file,
            statistics = log.topics.associate { it.name to it.statistics },
            units = log.topics.associate { it.name to it.unit },
            xUnit = log.xUnit,
        )
    }

private val NEWEST_FIRST = compareByDescending<LogEntry> { it.date.second }.thenBy { it.file }
