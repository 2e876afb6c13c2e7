package badlog.signals.clock

import badlog.core.analysis.Series
import badlog.signals.signalTopicsOf
import kotlin.math.ceil
import kotlin.math.round
import kotlin.math.sqrt

/**
 * Returns the relation of the clock of [log] to the clock of [other], found by the battery voltage in both. It changes alike wherever it is
 * measured. Null if one log lacks it, if it hardly changes, or if other offsets fit nearly as well.
 */
fun batteryFit(log: ClockedLog, other: ClockedLog): ClockFit? {
    val (own, others) = (batteryOf(log) ?: return null) to (batteryOf(other) ?: return null)
    val coarse = correlated(own.every(COARSE), others.every(COARSE)) ?: return null
    val (one, two) = own.every(FINE) to others.every(FINE)
    val around = (coarse - COARSE * 3).inSteps()..(coarse + COARSE * 3).inSteps()
    val fine = around.associateWith { lag -> correlation(one, two, lag) ?: -1.0 }
    val best = fine.maxBy { it.value }
    val alike = fine.filterValues { it > best.value - SAME }.keys
    val error = maxOf(best.key - alike.min(), alike.max() - best.key) * FINE + FINE
    return ClockFit(own.from(other = others, best.key * FINE), 0, error)
}

/**
 * Returns the correlation of the battery voltage in [log], moved by [seconds] s, with the battery voltage in [other], from -1 to 1. Null if
 * one log lacks it, or if it hardly changes.
 */
internal fun batteryLikeness(log: ClockedLog, other: ClockedLog, seconds: Double): Double? {
    val (own, others) = (batteryOf(log) ?: return null) to (batteryOf(other) ?: return null)
    val lag = round((seconds + own.begin - others.begin) / COARSE).toInt()
    val (one, two) = own.every(COARSE) to others.every(COARSE)
    return (lag - 1..lag + 1).mapNotNull { correlation(one, two, it) }.maxOrNull()
}

private fun Double.inSteps() = ceil(this / FINE).toInt()

private class Voltage(val series: Series, val secondsPerX: Double) {
    val begin = series.x.first() * secondsPerX
    private val end = series.x.last() * secondsPerX

    /** Returns the voltage every [step] s, from the first sample on; each is the last one before. */
    fun every(step: Double): DoubleArray {
        var at = 0
        return DoubleArray(((end - begin) / step).toInt() + 1) { i ->
            val time = begin + i * step
            while (at + 1 < series.size && series.x[at + 1] * secondsPerX <= time) at++
            series.y[at]
        }
    }

    /** Returns the offset of this clock if the first sample here is [lag] s after the first of [other]. */
    fun from(other: Voltage, lag: Double): Double = other.begin + lag - begin

    val seconds: Double get() = end - begin
}

private fun batteryOf(log: ClockedLog): Voltage? {
    val name = signalTopicsOf(log.view, log.vocabulary).of("battery").firstOrNull()?.topic ?: return null
    val topic = log.recording.topics.find { it.name == name } ?: return null
    val data = log.view.seriesOf(topic).data.takeIf { it.isOrdered } ?: return null
    val kept = data.y.indices.filter { data.y[it].isFinite() }
    if (kept.size < MIN_SAMPLES) return null
    val series = Series(DoubleArray(kept.size) { data.x[kept[it]] }, DoubleArray(kept.size) { data.y[kept[it]] })
    return Voltage(series, log.view.secondsPerX).takeIf { it.seconds in MIN_COMMON..LONGEST }
}

/** Returns the lag of [one] after [two] at which they move most alike, in s. Null if that is not clear. */
private fun correlated(one: DoubleArray, two: DoubleArray): Double? {
    val common = maxOf((MIN_COMMON / COARSE).toInt(), minOf(one.size, two.size) / 2)
    val lags = (common - one.size)..(two.size - common)
    if (lags.isEmpty()) return null
    val all = lags.map { it to (correlation(one, two, it) ?: -1.0) }
    val best = all.maxBy { it.second }
    val next = all.filter { (lag, _) -> lag - best.first !in -NEIGHBORS..NEIGHBORS }.maxOfOrNull { it.second } ?: -1.0
    return (best.first * COARSE).takeIf { best.second >= ALIKE && best.second - next >= CLEARER }
}

/** Returns how alike [one] and [two] move while both are there, from -1 to 1; null if one hardly moves. */
private fun correlation(one: DoubleArray, two: DoubleArray, lag: Int): Double? {
    val from = maxOf(0, -lag)
    val until = minOf(one.size, two.size - lag)
    val count = until - from
    if (count < 2) return null
    var meanOne = 0.0
    var meanTwo = 0.0
    for (i in from until until) {
        meanOne += one[i]
        meanTwo += two[i + lag]
    }
    meanOne /= count
    meanTwo /= count
    var both = 0.0
    var ofOne = 0.0
    var ofTwo = 0.0
    for (i in from until until) {
        val x = one[i] - meanOne
        val y = two[i + lag] - meanTwo
        both += x * y
        ofOne += x * x
        ofTwo += y * y
    }
    val least = MIN_VOLTS * MIN_VOLTS * count
    return if (ofOne < least || ofTwo < least) null else both / sqrt(ofOne * ofTwo)
}

private const val MIN_SAMPLES = 50

/** In seconds: the steps, first of all possible lags, then of those around the best. */
private const val COARSE = 0.2
private const val FINE = 0.02

/** In seconds: both must have this time in common, and neither may be longer than the maximum for a comparison. */
private const val MIN_COMMON = 30.0
private const val LONGEST = 1200.0

/** In V: the standard deviation of a battery that moves. */
private const val MIN_VOLTS = 0.05
internal const val ALIKE = 0.9
internal const val CLEARER = 0.15

/** So many steps around the best lag belong to it. */
private const val NEIGHBORS = 15
private const val SAME = 0.005
