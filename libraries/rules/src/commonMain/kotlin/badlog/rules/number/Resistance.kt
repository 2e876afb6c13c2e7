package badlog.rules.number

import badlog.core.analysis.Series
import kotlin.math.sqrt

/** The resistance of battery and wiring, and its uncertainty (95 %), both in milliohms. */
internal class Resistance(val milliohms: Double, val uncertainty: Double)

/**
 * Returns the slope of [volts] against [amps], and its uncertainty, which is estimated by leaving out each 10 s in turn, since
 * neighboring samples are nearly the same. Null if the current hardly changes, or for too short a time, or if the result is as
 * uncertain as a guess.
 *
 * @param end when the last samples end, in seconds like all times.
 */
internal fun resistanceOf(volts: Series, amps: Series, end: Double): Resistance? {
    if (!volts.isOrdered || !amps.isOrdered || volts.size == 0 || amps.size == 0) return null
    val blocks = ArrayList<Sums>()
    var blockEnd = Double.NEGATIVE_INFINITY
    var v = -1
    for (i in amps.x.indices) {
        val time = amps.x[i]
        while (v + 1 < volts.size && volts.x[v + 1] <= time) v++
        if (v < 0) continue
        val held = (if (i + 1 < amps.size) amps.x[i + 1] else end) - time
        val volt = volts.y[v]
        val amp = amps.y[i]
        if (!(held > 0) || !volt.isFinite() || !amp.isFinite() || volt < LEAST_VOLTS) continue
        if (time >= blockEnd) {
            blocks += Sums()
            blockEnd = time + BLOCK_SECONDS
        }
        blocks.last().add(minOf(held, LONGEST_HOLD), amp, volt)
    }
    val all = Sums()
    blocks.forEach { all.add(it, 1.0) }
    if (blocks.size < LEAST_BLOCKS || all.deviation < LEAST_DEVIATION) return null
    val slopes = blocks.map { block -> Sums().apply { add(all, 1.0) }.apply { add(block, -1.0) }.slope }
    val mean = slopes.average()
    val error = sqrt((slopes.size - 1.0) / slopes.size * slopes.sumOf { (it - mean) * (it - mean) })
    return Resistance(-MILLI * all.slope, 2 * MILLI * error).takeIf {
        it.milliohms.isFinite() &&
            it.uncertainty < it.milliohms * MOST_UNCERTAINTY
    }
}

private class Sums {
    private var weight = 0.0
    private var x = 0.0
    private var y = 0.0
    private var xx = 0.0
    private var xy = 0.0

    fun add(held: Double, amp: Double, volt: Double) {
        // Relative to a typical value, so that sums of squares keep their digits.
        val v = volt - USUAL_VOLTS
        weight += held
        x += held * amp
        y += held * v
        xx += held * amp * amp
        xy += held * amp * v
    }

    fun add(other: Sums, sign: Double) {
        weight += sign * other.weight
        x += sign * other.x
        y += sign * other.y
        xx += sign * other.xx
        xy += sign * other.xy
    }

    val slope: Double get() = (weight * xy - x * y) / (weight * xx - x * x)
    val deviation: Double get() = if (weight > 0) sqrt(maxOf(0.0, xx / weight - (x / weight) * (x / weight))) else 0.0
}

private const val MILLI = 1000.0
private const val USUAL_VOLTS = 12.0
private const val LEAST_VOLTS = 1.0
private const val BLOCK_SECONDS = 10.0
private const val LEAST_BLOCKS = 4

/** A value that was not logged for this long is not known. */
private const val LONGEST_HOLD = 1.0

/** A share of the resistance: what is known within no less is no measurement. */
private const val MOST_UNCERTAINTY = 0.5

/** The minimum variation of the current, in amperes. */
private const val LEAST_DEVIATION = 15.0
