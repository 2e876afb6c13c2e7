package badlog.signals.clock

import badlog.core.recording.CellCounts
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

/**
 * Returns the samples of this topic from index [from] until [until], as a topic called [name] at [times]. This topic has times of its own.
 */
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

/** Returns the samples [rows] of this topic, in that order, as a topic called [name] at [times]. */
internal fun Topic.picked(rows: IntArray, name: String, times: DoubleArray): Topic {
    val from = rows.firstOrNull() ?: 0
    if (rows.indices.all { rows[it] == from + it }) return slice(from, from + rows.size, name, times)
    val ids = textIds()
    val textRows = rows.indices.filter { ids[rows[it]] >= 0 }.toIntArray()
    val numbers = if (samples.isEmpty()) samples else DoubleArray(rows.size) { samples[rows[it]] }
    val column = TextColumn(textRows, IntArray(textRows.size) { ids[rows[textRows[it]]] }, texts.dictionary)
    return copy(samples = numbers, texts = column).slice(0, rows.size, name, times)
}

/** Returns the same as [picked], without the [rows] in which this topic has no sample. */
internal fun Topic.pickedSamples(rows: IntArray, name: String, times: DoubleArray): Topic {
    val ids = textIds()
    val set = rows.indices.filter { i -> ids[rows[i]] >= 0 || (samples.isNotEmpty() && !samples[rows[i]].isNaN()) }.toIntArray()
    return picked(IntArray(set.size) { rows[set[it]] }, name, DoubleArray(set.size) { times[set[it]] })
}

/** Returns the index of the text of each sample; -1 for a sample that is not a text. */
private fun Topic.textIds() = IntArray(size).also { ids ->
    ids.fill(-1)
    for (i in texts.rows.indices) ids[texts.rows[i]] = texts.ids[i]
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
