package badlog.cli.info

import badlog.cli.topic.TopicChoice
import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import java.nio.file.Path

/**
 * A summary of one log.
 *
 * @property bytes the size of its file.
 * @param numbers the summaries of numbers that are not in [view].
 * @param only the topics to include.
 */
internal class LogSummary(val file: Path, val bytes: Long, val view: LogView, numbers: StreamedNumbers, only: TopicChoice) {
    /** The smallest and the largest x, or null if there is none. */
    val range: ClosedFloatingPointRange<Double>? = view.xAxis.range

    /** The number of seconds in one unit of x, or null if x is not a time. */
    val secondsPerX: Double? = Units.secondsIn(view.xAxis.unit)

    /** Its length in seconds, or null if x is not a time. */
    val seconds: Double? get() = range?.let { range -> secondsPerX?.times(range.endInclusive - range.start) }

    /** The summaries of the topics, in the order of the file. */
    val topics: List<TopicSummary> =
        view.recording.topics.filter { it.name in only }.map { TopicSummary.of(it, numbers.of(it), view.xAxis, secondsPerX) }
}

/**
 * A summary of one topic.
 *
 * @property count the number of its samples: numbers, or texts of states and events.
 * @property rate samples per second from its first to its last; null if x is not a time or they are at the same x.
 * @property min the smallest finite number; NaN if there is none.
 * @property max the largest finite number; NaN if there is none.
 * @property gaps the number of gaps; null for texts and sparse topics, which always have them.
 */
internal class TopicSummary private constructor(
    val topic: Topic,
    val count: Int,
    val rate: Double?,
    val min: Double,
    val max: Double,
    val gaps: Int?,
) {
    /** Whether its samples are texts. */
    val hasTexts: Boolean get() = isText(topic.kind)

    companion object {
        /** Returns the summary of [topic] with [numbers], over [xAxis] in units of [secondsPerX] seconds. */
        fun of(topic: Topic, numbers: NumberSummary, xAxis: XAxis, secondsPerX: Double?): TopicSummary {
            val x = topic.times ?: xAxis.positions
            val isText = isText(topic.kind)
            val first = if (isText) topic.texts.rows.firstOrNull() ?: -1 else numbers.first
            val last = if (isText) topic.texts.rows.lastOrNull() ?: -1 else numbers.last
            val count = if (isText) topic.texts.size else numbers.count
            val hasGaps = !isText && topic.kind != TopicKind.EMPTY && !topic.isSparse
            return TopicSummary(
                topic = topic,
                count = count,
                rate = secondsPerX?.let { rate(count, x, first, last, it) },
                min = if (numbers.count > 0) numbers.min else Double.NaN,
                max = if (numbers.count > 0) numbers.max else Double.NaN,
                gaps = if (hasGaps) topic.counts.gaps else null,
            )
        }

        private fun rate(count: Int, x: DoubleArray, first: Int, last: Int, secondsPerX: Double): Double? {
            if (count < 2) return null
            val seconds = (x[last] - x[first]) * secondsPerX
            return if (seconds > 0 && seconds.isFinite()) (count - 1) / seconds else null
        }

        private fun isText(kind: TopicKind) = kind == TopicKind.STATE || kind == TopicKind.EVENT
    }
}
