package badlog.expression

import badlog.analysis.Series
import badlog.analysis.XAxis
import badlog.recording.CellCounts
import badlog.recording.TextColumn
import badlog.recording.Topic

/** The samples [calculated] of [virtual] as a topic of a recording with [xAxis], whose time went as [stretches] tell. */
internal fun calculatedTopic(virtual: VirtualTopic, calculated: Series, xAxis: XAxis, stretches: Stretches?): Topic {
    // Times of their own ascend, so that where the clock was set back only rows can tell the order of samples.
    val series = stretches?.inRows(calculated, xAxis.positions) ?: calculated
    val isOfRows = series.x === xAxis.positions
    return Topic(
        virtual.name,
        virtual.unit.ifEmpty { Topic.UNITLESS },
        attributes = emptyList(),
        series.y,
        TextColumn.EMPTY,
        countsOf(series.y, virtual.expression.type.isCondition),
        // A topic without a sample needs no clock.
        times = if (isOfRows || series.size == 0) null else series.x,
        metadata = "= ${virtual.expression}",
    )
}

private fun countsOf(samples: DoubleArray, areTruthValues: Boolean): CellCounts {
    var finite = 0
    var infinite = 0
    var gaps = 0
    for (i in samples.indices) {
        val sample = samples[i]
        if (sample.isFinite()) {
            finite++
        } else {
            if (sample.isInfinite()) infinite++
            if (i == 0 || samples[i - 1].isFinite()) gaps++
        }
    }
    return CellCounts(
        numbers = if (areTruthValues) 0 else finite,
        notFinite = infinite,
        truthValues = if (areTruthValues) finite else 0,
        texts = 0,
        empty = samples.size - finite - infinite,
        gaps = gaps,
    )
}
