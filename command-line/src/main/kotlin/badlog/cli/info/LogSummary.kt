package badlog.cli.info

import badlog.analysis.LogView
import badlog.analysis.Units
import java.nio.file.Path

/**
 * What there is to say about one log.
 *
 * @property bytes the size of its file.
 */
internal class LogSummary(val file: Path, val bytes: Long, val view: LogView) {
    /** The smallest and the largest x, or null without any. */
    val range: ClosedFloatingPointRange<Double>? = view.xAxis.range

    /** How many seconds one unit of x is, or null when x is no time. */
    val secondsPerX: Double? = Units.secondsIn(view.xAxis.unit)

    /** How long it is in seconds, or null when x is no time. */
    val seconds: Double? get() = range?.let { range -> secondsPerX?.times(range.endInclusive - range.start) }

    /** Each topic, in the order of the file. */
    val topics: List<TopicSummary> = view.recording.topics.map { TopicSummary.of(it, view.xAxis, secondsPerX) }
}
