package badlog.signals.clock

import badlog.core.recording.CellCounts
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

/** Returns the samples of this topic, which has times of its own, from index [from] until [until], as a topic called [name] at [times]. */
internal fun Topic.slice(from: Int, until: Int, name: String, times: DoubleArray): Topic {
    val kept = texts.rows.indices.filter { texts.rows[it] in from until until }
    val rows = IntArray(kept.size) { texts.rows[kept[it]] - from }
    val column = TextColumn(rows, IntArray(kept.size) { texts.ids[kept[it]] }, texts.dictionary)
    val numbers = if (samples.isEmpty()) samples else samples.copyOfRange(from, until)
    val counts = countsOf(numbers, until - from, rows)
    return copy(
        name = name,
        samples = numbers.takeIf {
            counts.texts + counts.empty < counts.total
        } ?: DoubleArray(0),
        texts = column,
        counts = counts,
        times = times,
    )
}

private fun Topic.countsOf(samples: DoubleArray, size: Int, textRows: IntArray): CellCounts {
    var finite = 0
    var notFinite = 0
    var gaps = 0
    var isInGap = false
    for (i in 0 until size) {
        val sample = if (samples.isEmpty()) Double.NaN else samples[i]
        if (sample.isFinite()) {
            finite++
        } else if (!sample.isNaN()) {
            notFinite++
        }
        if (sample.isNaN() && !isInGap) gaps++
        isInGap = sample.isNaN()
    }
    val isTruth = kind == TopicKind.BOOLEAN
    // NaN in a log of the Driver Station is always a gap.
    val empty = size - finite - notFinite - textRows.size
    return CellCounts(if (isTruth) 0 else finite, notFinite, if (isTruth) finite else 0, textRows.size, empty, gaps)
}
