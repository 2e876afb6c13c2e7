package badlog.expression

import badlog.expression.signals.Signals
import kotlin.math.round

/** The duration of values and conditions in a recording, even if its clock was set back. */
internal class SlowTime(private val signals: Signals, private val noise: Noise) {
    val range = signals.range
    val course = signals.vocabulary.signals.map { signals.series(it.name).x.toList() }
        .firstOrNull { x -> x.zipWithNext().any { (a, b) -> b < a } }?.let { SlowCourse(it, noise.tick) }

    /** An unknown sample, from the start of the recording on. */
    fun unknown() = SlowValue(if (range == null) emptyList() else listOf(Row(range.from, null)))

    /** Holds in [spans]. */
    fun steps(spans: List<Pair<Double, Double>>): SlowValue {
        if (range == null) return SlowValue(emptyList())
        val ends = spans.map { it.second }.filter { it < range.to }
        val times = (spans.map { it.first } + ends + range.from).filter { it >= range.from && it <= range.to }.distinct().sorted()
        return SlowValue(times.map { time -> Row(time, spans.any { time >= it.first && (time < it.second || it.second >= range.to) }) })
    }

    fun begin(value: SlowValue) = value.course?.times?.first() ?: range?.from ?: 0.0

    fun end(value: SlowValue) = value.course?.let { maxOf(it.times.last(), value.rows!!.lastOrNull()?.time ?: 0.0) } ?: range?.to ?: 0.0

    /** Returns the time until which a sample holds: the next sample's, or the end. A moment is over at once. */
    fun until(value: SlowValue, index: Int): Double {
        val rows = value.rows!!
        val time = rows[index].time
        return if (value.isMomentary) time else minOf(rows.getOrNull(index + 1)?.time ?: end(value), end(value))
    }

    /** Returns the times at which a condition holds. Each lasts from a first true row to the next that is not, or the end. */
    fun spans(value: SlowValue): List<Pair<Double, Double>> {
        if (value.isMomentary) return value.rows!!.filter { it.value == true }.map { it.time to it.time }
        val rows = value.rows!!.filter { it.time <= end(value) }
        return rows.indices.filter { rows[it].value == true && (it == 0 || rows[it - 1].value != true) }.map { begin ->
            val end = (begin until rows.size).firstOrNull { rows[it].value != true }
            rows[begin].time to (if (end == null) end(value) else rows[end].time)
        }
    }

    /** The length of [span], without the ticks of a course. */
    fun width(span: Pair<Double, Double>) = round((span.second - span.first) * WITHOUT_TICKS) / WITHOUT_TICKS

    /** Adds a sample every 20 ms while a value holds, unless it is logged in rows. */
    fun refined(value: SlowValue): SlowValue {
        val rows = value.rows!!
        if (rows.isEmpty() || rows.map { it.time } == (value.course?.times ?: signals.rows?.toList())) return value
        return value.with(
            rows.indices.flatMap { i ->
                val width = until(value, i) - rows[i].time
                val steps = if (width > 0.03) (noise.of(width / 0.02) - 0.5).toInt() else 0
                (0..steps).map { Row(rows[i].time + it * 0.02, rows[i].value) }
            },
        )
    }
}

private const val WITHOUT_TICKS = 1L shl 36
