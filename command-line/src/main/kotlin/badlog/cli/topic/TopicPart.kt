package badlog.cli.topic

import badlog.core.recording.Recording
import badlog.core.recording.Topic

/** Returns the samples [indices] of this topic, in this order, at [times], or in rows if that is null. */
internal fun Topic.part(indices: IntArray, times: DoubleArray? = null): Topic {
    val source = CellSource(this)
    val builder = TopicBuilder(name, this, indices.size)
    for (index in indices) source.addTo(builder, index)
    return builder.build(times)
}

/** Returns the rows [runs] of this recording, as a recording. */
internal fun Recording.part(runs: List<IntRange>): Recording {
    if (runs == listOf(0 until rowCount)) return this
    val rows = runs.flatMap { it }.toIntArray()
    return copy(topics = topics.map { it.part(rows) }, rowCount = rows.size)
}

/** Returns this topic with other [attributes]. */
internal fun Topic.with(attributes: List<String>): Topic = if (attributes == this.attributes) this else copy(attributes = attributes)
