package badlog.core.analysis

import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.core.text.freeName
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.round

/**
 * Returns the samples of [recording] in rows, one for each of [times]. In each row, a topic has its last value at or before that time, and
 * nothing before its first sample. A sample less than a nanosecond after a row is in that row, because times are rounded. An event is in
 * the first row that is not before it; several events of one row are joined by `; `. A sample of a topic that [was sparse][Topic.wasSparse]
 * goes to its row in the same way; of several in one row, the last one counts. The first topic is `Time`, with these times, as the x axis.
 * If the recording was made from rows, the topic that [was their x axis][Topic.wasXAxis] is the x axis again. The result can be written as
 * a bag or as CSV.
 *
 * @param times ascending and finite, in the unit of the recording's x axis.
 * @throws IllegalArgumentException if they are not.
 */
public fun resampled(recording: Recording, times: DoubleArray): Recording {
    for (i in times.indices) {
        val isAscending = i == 0 || times[i] > times[i - 1]
        require(times[i].isFinite() && isAscending) { "Times must ascend, but ${times[i]} is at $i." }
    }
    val xAxis = LogView.of(recording).xAxis
    val formerX = recording.topics.find { it.wasXAxis && it.samples.isNotEmpty() }
    val topics = recording.topics.filter { it !== xAxis.topic }.map { topic ->
        val resampled = resampledTopic(topic, xAxis, times)
        if (topic === formerX) restoredXAxis(resampled, times) else resampled
    }
    return recording.copy(
        format = RecordingFormat.BAG,
        headerLine = null,
        topics = if (formerX == null) listOf(newXAxis(recording, xAxis.unit, times)) + topics else topics,
        rowCount = times.size,
    )
}

private fun newXAxis(recording: Recording, unit: String, times: DoubleArray): Topic {
    val names = recording.topics.mapTo(HashSet()) { it.name }
    val name = freeName("Time") { it !in names }
    return Topic(name, unit, listOf("xaxis", "hide"), times, TextColumn.EMPTY, xCounts(times))
}

/** Returns the topic [former] as the x axis. Its own numbers are kept where they agree with [times], because they are more precise. */
private fun restoredXAxis(former: Topic, times: DoubleArray): Topic {
    val inSeconds = Units.microsIn(former.unit) / 1e6
    val x = DoubleArray(times.size) { row ->
        val own = former.samples[row]
        if (abs(own * inSeconds - times[row]) <= MICROSECOND) own else times[row] / inSeconds
    }
    return Topic(former.name, former.unit, listOf("xaxis") + former.attributes, x, TextColumn.EMPTY, xCounts(times))
}

private fun xCounts(times: DoubleArray) = CellCounts(times.size, 0, 0, 0, 0, 0)

/**
 * Returns times [period] apart, from the first sample of [recording] on. The last time is not before the last sample.
 *
 * @param period in the unit of the x axis; above 0.
 * @throws IllegalArgumentException if [period] is not above 0, or if there would be more than 100 million times.
 */
public fun periodicTimes(recording: Recording, period: Double): DoubleArray {
    require(period > 0) { "A period must be above 0, but is $period." }
    val range = LogView.of(recording).xAxis.range ?: return DoubleArray(0)
    val steps = ceil((range.endInclusive - range.start) / period - ROUNDING)
    require(steps < MAX_ROWS) { "A period of $period gives $steps rows, which are too many." }
    return periodicTimes(range.start, period, steps.toInt() + 1)
}

/** Returns [count] times from [from] on, [period] apart, without the rounding errors in their last digits. */
public fun periodicTimes(from: Double, period: Double, count: Int): DoubleArray = DoubleArray(count) {
    val time = from + it * period
    if (period >= MICROSECOND) round(time * ROUNDING_SCALE) / ROUNDING_SCALE else time
}

/** Returns the times at which [topic], a topic of [recording], has samples: each once, in ascending order. */
public fun timesOf(recording: Recording, topic: Topic): DoubleArray {
    val positions = positionsOf(topic, LogView.of(recording).xAxis).filter { it.isFinite() }.toDoubleArray()
    positions.sort()
    var size = 0
    for (position in positions) if (size == 0 || position > positions[size - 1]) positions[size++] = position
    return positions.copyOf(size)
}

/**
 * Returns the number of samples of [topic] that are in none of the rows that [resampled] makes at [times]. [topic] must have times of its
 * own.
 */
public fun samplesBetween(topic: Topic, times: DoubleArray): Long {
    val own = topic.times ?: return 0
    // All events before a row are in it.
    if (topic.kind == TopicKind.EVENT || "log" in topic.attributes) {
        return own.count { times.isEmpty() || it > times.last() + MAX_LATENESS }.toLong()
    }
    var lost = 0L
    var row = 0
    for (i in own.indices) {
        while (row < times.size && times[row] + MAX_LATENESS < own[i]) row++
        val isShown = row < times.size && (i == own.lastIndex || own[i + 1] > times[row] + MAX_LATENESS)
        if (!isShown) lost++
    }
    return lost
}

private fun resampledTopic(topic: Topic, xAxis: XAxis, times: DoubleArray): Topic {
    val positions = positionsOf(topic, xAxis)
    val isOrdered = Series(positions, positions).isOrdered
    // If a clock was set back, samples out of order would be found by none of the times.
    val order = if (isOrdered) {
        null
    } else {
        stableOrder(positions, positions.indices.filter { positions[it].isFinite() }.toIntArray())
    }
    val sampler = LastValueSampler(topic, times.size)
    var next = 0
    val count = order?.size ?: topic.size
    for (row in times.indices) {
        while (next < count) {
            val index = order?.get(next) ?: next
            if (positions[index] > times[row] + MAX_LATENESS) break
            sampler.advanceTo(index)
            next++
        }
        sampler.endRow(row)
    }
    return sampler.build()
}

/** Puts the last sample of a topic at each time into that time's row. */
private class LastValueSampler(private val topic: Topic, rows: Int) {
    private val isEvent = topic.kind == TopicKind.EVENT || "log" in topic.attributes

    // Without a gap, each NaN was logged as such.
    private val isNaNValue = topic.counts.notFinite > 0 && topic.counts.empty == 0
    private var nans = 0
    private val samples = if (topic.samples.isEmpty()) DoubleArray(0) else DoubleArray(rows) { Double.NaN }
    private val textOf = IntArray(topic.size) { -1 }
    private val dictionary = ArrayList(topic.texts.dictionary)
    private val idOfText = HashMap<String, Int>()
    private val textIds = IntArray(rows) { -1 }
    private var last = -1
    private var text = -1

    init {
        for (i in 0 until topic.texts.size) textOf[topic.texts.rows[i]] = topic.texts.ids[i]
    }

    fun advanceTo(index: Int) {
        // Empty cells of a sparse topic are not samples.
        if (topic.isSparse && textOf[index] < 0 && topic.samples.getOrElse(index) { Double.NaN }.isNaN()) return
        last = index
        val textId = textOf[index]
        text = if (isEvent && text >= 0 && textId >= 0) {
            joined(text, textId)
        } else if (isEvent && textId < 0) {
            text
        } else {
            textId
        }
    }

    private fun joined(one: Int, other: Int): Int {
        val joined = dictionary[one] + "; " + dictionary[other]
        return idOfText.getOrPut(joined) {
            dictionary += joined
            dictionary.lastIndex
        }
    }

    fun endRow(row: Int) {
        if (last < 0) return
        textIds[row] = text
        if (samples.isNotEmpty() && textOf[last] < 0) {
            samples[row] = topic.samples[last]
            if (isNaNValue && samples[row].isNaN()) nans++
        }
        if (isEvent) text = -1
        if (topic.wasSparse) last = -1
    }

    fun build(): Topic {
        val rows = textIds.indices.filter { textIds[it] >= 0 }.toIntArray()
        val texts = TextColumn(rows, IntArray(rows.size) { textIds[rows[it]] }, dictionary)
        return Topic(topic.name, topic.unit, attributes(), samples, texts, counts(rows.size))
    }

    // Without the attribute, a reader could take a topic with an event in few of many rows for a state.
    private fun attributes() = if (isEvent && "log" !in topic.attributes) topic.attributes + "log" else topic.attributes

    private fun counts(texts: Int): CellCounts {
        val total = textIds.size
        val finite = samples.count { it.isFinite() }
        val infinite = samples.count { it.isInfinite() }
        val gaps = textIds.indices.count { row -> isGap(row) && (row == 0 || !isGap(row - 1)) }
        val isTruth = topic.counts.truthValues > 0 && topic.counts.numbers == 0
        return CellCounts(
            numbers = if (isTruth) 0 else finite,
            notFinite = infinite + nans,
            truthValues = if (isTruth) finite else 0,
            texts = texts,
            empty = total - finite - infinite - nans - texts,
            gaps = gaps,
        )
    }

    private fun isGap(row: Int) = samples.isEmpty() || samples[row].isNaN()
}

// The tolerance, in periods, for the last step of a period that divides the range.
private const val ROUNDING = 1e-9
private const val MICROSECOND = 1e-6
private const val MAX_ROWS = 1e8

/** Times are rounded to this fraction of a unit of x. */
private const val ROUNDING_SCALE = 1e9

/** A sample up to this much later than a row is in that row. Times of rows are rounded, and 829 times 0.02 s is 16.580000000000002 s. */
private const val MAX_LATENESS = 1 / ROUNDING_SCALE
