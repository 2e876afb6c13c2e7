package badlog.formats.wpilog

import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import badlog.core.recording.Topic
import kotlin.math.abs
import kotlin.math.round

/** Converts positions on [xAxis] to the times of records: whole µs, from 0 on. */
internal class RecordTimes(private val xAxis: XAxis) {
    private val scale = Units.microsIn(xAxis.unit)
    private val isTime = !xAxis.isIndex && (Units.secondsIn(xAxis.unit) != null || Units.isNone(xAxis.unit))

    /** The number added to every x, so that none is before 0. */
    private val shift = maxOf(0.0, -(xAxis.range?.start ?: 0.0))

    /** The number of times that had to be rounded. */
    private var rounded = 0

    /** The time of the first sample, in µs. */
    val first: Double get() = xAxis.range?.let { micros(it.start) } ?: 0.0

    /** Returns the position of each sample of [topic] on the x axis. */
    fun positionsOf(topic: Topic): DoubleArray = topic.times ?: xAxis.positions

    /** Returns the time for the position [x], in µs. NaN if [x] is NaN, or if the time is before 0 or later than a record can be. */
    fun micros(x: Double): Double {
        val exact = (x + shift) * scale
        if (!(exact >= 0 && exact < MAX_MICROS)) return Double.NaN
        val whole = round(exact)
        if (abs(exact - whole) > TOLERANCE + exact * 1e-15) rounded++
        return whole
    }

    /** Returns the properties of x that the times no longer express. */
    fun omissions(): List<Omission> = buildList {
        if (!isTime) add(Omission(null, "The x axis “${xAxis.title}” is not a time; one unit is written as one second."))
        if (shift > 0) add(Omission(null, "x starts at ${xAxis.range?.start}; $shift was added to all times."))
        if (rounded > 0) add(Omission(null, "Times were rounded to microseconds.", rounded))
    }
}

private const val TOLERANCE = 1e-3

/** The limit of record times: 2^53 µs. */
private const val MAX_MICROS = 9007199254740992.0
