package badlog.window.export

import badlog.core.analysis.Span
import badlog.core.analysis.resampled
import badlog.core.recording.Recording
import badlog.viewer.shown.table.TableRows
import badlog.viewer.shown.table.rowsWithin
import badlog.window.log.OpenRecording

/**
 * A part to cut out of a recording.
 *
 * @property rows the rows of [recording] to cut out; empty for none.
 * @property remark an addition to a sentence about how the rows were made; empty if they are rows of the file.
 */
internal class Cut(val recording: Recording, val rows: IntRange, val remark: String = "")

/** Returns the part of [recording] in [span]. For topics with times of their own, it makes rows, see [TableRows]. */
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
    val part = Span(maxOf(span.from, range.start), minOf(span.to, range.endInclusive))
    if (!(part.from <= part.to)) return Cut(whole, IntRange.EMPTY)
    val densest = whole.topics.maxBy { topic -> topic.times?.count { it in part } ?: 0 }
    val made = TableRows.of(part, whole.topics.size, densest.name, densest.times ?: DoubleArray(0))
    return Cut(resampled(whole, made.times), made.times.indices, made.remark)
}

/** Returns the rows of the file, with a column for each formula that has a value in each row. */
private fun rowsOf(recording: OpenRecording, whole: Recording, span: Span): Cut {
    val rows = rowsWithin(recording.view.xAxis.positions, span)
    val (columns, others) = whole.topics.partition { topic ->
        recording.signal(topic.name)?.definition == null || (topic.times == null && topic.samples.size == whole.rowCount)
    }
    if (others.isEmpty()) return Cut(whole, rows)
    val names = others.joinToString { "“${it.name}”" }
    return Cut(whole.copy(topics = columns), rows, ", without $names, which does not have a value in each row")
}
