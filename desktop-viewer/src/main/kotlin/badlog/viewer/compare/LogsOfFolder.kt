package badlog.viewer.compare

import badlog.viewer.app.Viewer

/** Every log of the folder, with the figures of all its topics that are known without reading it again. */
internal fun logsOfFolder(viewer: Viewer): List<StatisticsRow> =
    viewer.library.entries.filter { it.isReadable && it.topics.isNotEmpty() }.map { log ->
        StatisticsRow(
            label = log.title,
            date = log.date.time.toString().replace('T', ' '),
            path = log.file,
            statistics = log.topics.associate { it.name to it.statistics },
            units = log.topics.associate { it.name to it.unit },
            xUnit = log.xUnit,
        )
    }
