package badlog.core.analysis

import badlog.core.recording.Topic
import kotlin.math.abs

/**
 * Returns the average number of samples per second of [topic], a topic of this view. Gaps count as samples. The time is measured from the
 * first to the last sample. NaN if it has fewer than two samples, or if the x axis does not have a unit of time. An axis without a unit is
 * taken to be in seconds, unless it is the row index.
 */
public fun LogView.sampleRateOf(topic: Topic): Double {
    val ownTimes = topic.times
    val positions = ownTimes ?: if (topic.size == recording.rowCount) xAxis.positions else return Double.NaN
    val secondsPerX = if (ownTimes != null || Units.isNone(xAxis.unit)) 1.0 else Units.secondsIn(xAxis.unit) ?: return Double.NaN
    if (ownTimes == null && xAxis.isIndex) return Double.NaN
    val first = positions.firstOrNull { it.isFinite() } ?: return Double.NaN
    val last = positions.last { it.isFinite() }
    val seconds = abs(last - first) * secondsPerX
    return if (seconds > 0) (positions.size - 1) / seconds else Double.NaN
}
