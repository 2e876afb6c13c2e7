package badlog.season.lake

import badlog.core.analysis.LogView
import badlog.core.recording.Topic
import badlog.season.engine.FieldType
import badlog.season.engine.MomentColumn
import badlog.season.engine.NumberColumn
import badlog.season.engine.RecordColumn
import badlog.season.engine.Table

/** Returns the samples of the topics of [view] with times of their own, one row per sample, topic after topic. Null if there are none. */
internal fun seriesTable(view: LogView, log: String, identity: LogIdentity): Table? {
    val topics = view.recording.topics.filter { it.times != null && it.times!!.isNotEmpty() }.sortedBy { it.name }
    val size = topics.sumOf { it.times!!.size.toLong() }
    if (size == 0L || size > Int.MAX_VALUE) return null
    val samples = SeriesCursor(topics, size.toInt())
    val columns = listOfNotNull(
        RecordColumn("topic", FieldType.TEXT) { samples.at(it).topic.name },
        NumberColumn(FixedColumns.T, samples.times),
        identity.zero?.let { MomentColumn(FixedColumns.TIMESTAMP, it, samples.times) },
        RecordColumn("value", FieldType.NUMBER) { samples.at(it).value },
        RecordColumn("text", FieldType.TEXT) { samples.at(it).text },
    )
    return Table(columns, size.toInt(), constantsOf(log, identity))
}

/** The [size] samples of [topics], one topic after the other. */
private class SeriesCursor(private val topics: List<Topic>, size: Int) {
    val times = DoubleArray(size)
    private val starts = IntArray(topics.size + 1)
    private val texts = topics.map(::TextsInRows)
    private var place = 0

    /** The content of the current row. */
    var topic: Topic = topics.first()
        private set
    private var sample = 0

    init {
        topics.forEachIndexed { i, topic ->
            val own = topic.times!!
            own.copyInto(times, starts[i])
            starts[i + 1] = starts[i] + own.size
        }
    }

    /** Moves to [row], and returns this; rows are usually requested in ascending order. */
    fun at(row: Int): SeriesCursor {
        if (row < starts[place]) place = 0
        while (row >= starts[place + 1]) place++
        topic = topics[place]
        sample = row - starts[place]
        return this
    }

    val value: Double get() = if (hasTextCells(topic)) Double.NaN else topic.samples.getOrElse(sample) { Double.NaN }

    /** The text of the sample, even in a topic of numbers; null if it has none. */
    val text: String?
        get() = when {
            hasTextCells(topic) || value.isNaN() -> texts[place].of(sample)
            else -> null
        }
}
