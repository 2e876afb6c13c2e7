package badlog.catalog.folder

import badlog.core.analysis.Series
import badlog.core.analysis.statistics
import badlog.core.recording.TopicKind
import badlog.files.LogFile
import badlog.signals.battery.BatteryUse
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.catalog.PreviewLine
import badlog.viewer.catalog.TopicSummary
import java.nio.file.Path
import kotlin.math.sin

/** An entry of a file that does not exist. */
internal fun entry(
    name: String,
    match: MatchOfLog = MatchOfLog(),
    second: Long = 0,
    content: Content = Content.SOMETHING,
    batteryMinimum: Double? = null,
    topics: List<TopicSummary> = emptyList(),
) = LogEntry(
    source = LogFile(Path.of("/logs").toAbsolutePath().resolve(name), name.length * 1000L, second * 1000),
    summary = LogSummary(
        match = match,
        date = LogDate(second, DateSource.VALUES),
        duration = 150.0,
        xUnit = "s",
        samples = 75_000,
        content = content,
        battery = BatteryUse(topic = topics.firstOrNull()?.name, lowest = batteryMinimum),
        topics = topics,
    ),
)

/** Returns a topic with a wave of [height] as its course. */
internal fun topic(name: String, height: Double = 1.0): TopicSummary {
    val series = Series(DoubleArray(500) { it * 0.02 }, DoubleArray(500) { height * sin(it * 0.05) })
    val statistics = series.statistics()
    return TopicSummary(name, "V", TopicKind.NUMERIC, statistics, PreviewLine.of(series, statistics.min, statistics.max))
}
