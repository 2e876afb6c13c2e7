package badlog.window.export

import badlog.core.analysis.Span
import badlog.core.analysis.periodicTimes
import badlog.core.analysis.resampled
import badlog.core.analysis.timesOf
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.window.log.OpenRecording
import kotlin.math.floor

/**
 * A part to cut out of a recording.
 *
 * @property rows the rows of [recording] in it; empty for nothing.
 * @property remark the way the rows were made, to append to a sentence; empty if they are rows of the file.
 */
internal class Cut(val recording: Recording, val rows: IntRange, val remark: String = "")

/**
 * Returns the part of [recording] in [span]. For topics with times of their own, it makes rows. There is one every 20 ms, as often as a
 * robot's program runs, or one at each sample of a topic that has more.
 */
internal fun partOf(recording: OpenRecording, span: Span): Cut {
    // The Driver Station's topics stay in its own file.
    val whole = recording.view.recording.run { copy(topics = topics.filter { it.name !in recording.stationTopics }) }
    if (recording.logged.recording.topics.none {
            it.times != null && it.name !in recording.stationTopics
        }
    ) {
        return rowsOf(recording, whole, span)
    }
    val range = recording.view.xAxis.range ?: return Cut(whole, IntRange.EMPTY)
    val from = maxOf(span.from, range.start)
    val to = minOf(span.to, range.endInclusive)
    if (!(from <= to)) return Cut(whole, IntRange.EMPTY)
    // Many topics over many hours would need more memory than there is.
    val maxRows = MAX_CELLS / (whole.topics.size + 1.0)
    val period = generateSequence(PERIOD) { it * 2 }.first { (to - from) / it < maxRows }
    val periodic = floor((to - from) / period + ROUNDING).toInt() + 1
    val (densest, count) = whole.topics.map { it to countWithin(it, from, to) }.maxBy { it.second }
    if (count > periodic && count < maxRows) {
        val times = timesOf(whole, densest).filter { it in from..to }.toDoubleArray()
        return Cut(resampled(whole, times), times.indices, ", one at each sample of “${densest.name}”$HELD")
    }
    val times = periodicTimes(from, period, periodic)
    return Cut(resampled(whole, times), times.indices, ", one every ${(period * 1000).toInt()} ms$HELD")
}

/** Returns the rows of the file, with a column for each formula that has a value in each row. */
private fun rowsOf(recording: OpenRecording, whole: Recording, span: Span): Cut {
    val rows = rowsWithin(recording, span)
    val (columns, others) = whole.topics.partition { topic ->
        recording.signal(topic.name)?.definition == null || (topic.times == null && topic.samples.size == whole.rowCount)
    }
    if (others.isEmpty()) return Cut(whole, rows)
    val names = others.joinToString { "“${it.name}”" }
    return Cut(whole.copy(topics = columns), rows, ", without $names, which does not have a value in each row")
}

private fun countWithin(topic: Topic, from: Double, to: Double) = topic.times?.count { it in from..to } ?: 0

private const val HELD = ", each with the last values before it"

/** The shortest time between two made rows, in seconds. */
private const val PERIOD = 0.02
private const val MAX_CELLS = 40e6

// The tolerance, in periods, for the last step of a period that divides the range.
private const val ROUNDING = 1e-9

/**
 * Returns the rows of [recording] from the first to the last with an x in [span]. Empty if there is none. If x is missing or goes
 * backwards, the rows in between are included: a cut keeps the file's order and all of its rows.
 */
internal fun rowsWithin(recording: OpenRecording, span: Span): IntRange {
    val positions = recording.view.xAxis.positions
    val first = positions.indexOfFirst { it in span }
    return if (first < 0) IntRange.EMPTY else first..positions.indexOfLast { it in span }
}
