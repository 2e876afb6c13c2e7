package badlog.core.analysis

import badlog.core.recording.PathName
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

/** Returns the x of each sample of [topic]: the topic's own times, or the rows' x. */
internal fun positionsOf(topic: Topic, xAxis: XAxis): DoubleArray = topic.times ?: xAxis.positions

/** Returns the numbers of [topic] over [xAxis]. Rows without an x and empty cells of a sparse topic are dropped. */
internal fun samplesOf(topic: Topic, xAxis: XAxis): Series {
    val x = positionsOf(topic, xAxis)
    val y = topic.samples
    if (y.isEmpty() || x.isEmpty()) return Series(DoubleArray(0), DoubleArray(0))
    val isSparse = topic.isSparse
    // The case of nearly every topic in a log with rows.
    if (!isSparse && x === xAxis.positions && xAxis.isEverywhere && x.size == y.size) return Series(x, y)
    var kept = 0
    for (i in y.indices) if (isDrawable(x[i], y[i], isSparse)) kept++
    if (kept == y.size) return Series(x, y)
    val keptX = DoubleArray(kept)
    val keptY = DoubleArray(kept)
    var size = 0
    for (i in y.indices) {
        if (!isDrawable(x[i], y[i], isSparse)) continue
        keptX[size] = x[i]
        keptY[size++] = y[i]
    }
    return Series(keptX, keptY)
}

/** Returns the states of a [TopicKind.STATE] topic over [xAxis], as indices into its dictionary. A cell without text is a gap. */
internal fun statesOf(topic: Topic, xAxis: XAxis): Series {
    val positions = positionsOf(topic, xAxis)
    val texts = topic.texts
    val states = DoubleArray(topic.counts.total) { Double.NaN }
    for (i in 0 until texts.size) states[texts.rows[i]] = texts.ids[i].toDouble()
    val rows = states.indices.filter { positions.getOrElse(it) { Double.NaN }.isFinite() }
    if (rows.size == states.size) return Series(positions, states)
    return Series(
        DoubleArray(rows.size) { positions[rows[it]] },
        DoubleArray(rows.size) { states[rows[it]] },
    )
}

/** Returns [topic] as a line of its own: its numbers or its states. */
internal fun seriesOf(topic: Topic, xAxis: XAxis): GraphSeries {
    val name = PathName.baseNameOf(topic.name)
    return when (topic.kind) {
        TopicKind.STATE ->
            GraphSeries(name, topic.unit, topic, topic.texts.dictionary, range = xAxis::range) { statesOf(topic, xAxis) }

        TopicKind.BOOLEAN ->
            GraphSeries(name, topic.unit, topic, listOf("false", "true"), range = xAxis::range) { samplesOf(topic, xAxis) }

        else -> GraphSeries(name, topic.unit, topic, null, range = xAxis::range) { samplesOf(topic, xAxis) }
    }
}

private fun isDrawable(x: Double, y: Double, isSparse: Boolean) = x.isFinite() && (!isSparse || !y.isNaN())
