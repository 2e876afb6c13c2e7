package badlog.viewer.compare

import badlog.viewer.app.Viewer
import badlog.viewer.library.index.LogEntry

/** Every log of the folder, the newest first, with the figures of all its topics that are known without reading it again. */
internal fun logsOfFolder(viewer: Viewer): List<StatisticsRow> =
    viewer.library.entries.filter { it.isReadable && it.topics.isNotEmpty() }.sortedWith(NEWEST_FIRST).map { log ->
        StatisticsRow(
            label = log.title,
            date = log.date.time.toString().replace('T', ' '),
            path = log.file,
            statistics = log.topics.associate { it.name to it.statistics },
            units = log.topics.associate { it.name to it.unit },
            xUnit = log.xUnit,
        )
    }

private val NEWEST_FIRST = compareByDescending<LogEntry> { it.date.second }.thenBy { it.file }
