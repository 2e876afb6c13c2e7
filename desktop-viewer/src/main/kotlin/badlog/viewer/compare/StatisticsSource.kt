package badlog.viewer.compare

import badlog.analysis.statistics
import badlog.recording.PathName
import badlog.viewer.app.Viewer
import badlog.viewer.recording.OpenRecording
import java.io.IOException
import java.nio.file.Files
import java.time.ZoneId
import java.time.format.DateTimeFormatter

/**
 * What the table of statistics is made from.
 *
 * @property topics the names of all topics that can be asked for, by folder.
 * @property rowsOf finds the figures of some of them in every recording; takes its time, so not for the window's thread.
 */
internal class StatisticsSource(val topics: List<String>, val rowsOf: (topics: List<String>) -> List<StatisticsRow>)

/** What the table is made from: the open recording and those ticked, or all that are known. To be used on the window's thread. */
internal fun statisticsSource(viewer: Viewer): StatisticsSource {
    val recordings = viewer.drawnRecordings().map { it.recording }
    val topics = recordings.flatMap { recording -> recording.signals.filter { it.hasFigures }.map { it.name } }
    return StatisticsSource(topics.distinct().sortedBy { PathName.folderOf(it).lowercase() }) { asked ->
        recordings.map { statisticsRow(it, asked) }
    }
}

/** The figures of [topics] in [recording], those that it has. */
internal fun statisticsRow(recording: OpenRecording, topics: List<String>): StatisticsRow {
    val signals = topics.mapNotNull { recording.signal(it) }.filter { it.hasFigures }
    return StatisticsRow(
        label = recording.label,
        date = dateOf(recording),
        path = recording.file,
        statistics = signals.associate { it.name to it.series.statistics() },
        units = signals.associate { it.name to it.unit },
        xUnit = recording.view.xAxis.unit,
    )
}

private fun dateOf(recording: OpenRecording): String = try {
    DATE.format(Files.getLastModifiedTime(recording.file).toInstant().atZone(ZoneId.systemDefault()))
} catch (_: IOException) {
    ""
}

private val DATE = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm")
