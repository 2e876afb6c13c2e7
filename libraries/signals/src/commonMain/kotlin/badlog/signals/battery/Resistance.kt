package badlog.signals.battery

import badlog.core.analysis.Series
import kotlin.math.sqrt

/** The resistance of battery and wiring, and its uncertainty (95 %), both in milliohms. */
data class Resistance(val milliohms: Double, val uncertainty: Double)

/**
 * Returns the slope of [volts] against [amps] as a resistance, with its uncertainty. It is fitted within each 10 s, so that a battery that
 * empties does not count as resistance. The uncertainty is estimated by leaving out each 10 s in turn (the jackknife), since neighboring
 * samples are nearly the same. It includes noise and emptying, but not that a battery's resistance is higher for a long load than for a
 * short one. Null if the current hardly changes, or for too short a time, or if the result is too uncertain to tell one battery from
 * another.
 *
 * @param end the time at which the last samples end, in seconds like all times.
 */
fun resistanceOf(volts: Series, amps: Series, end: Double): Resistance? {
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
        if (!(held > 0) || !volt.isFinite() || !amp.isFinite() || volt < MIN_VOLTS) continue
        if (time >= blockEnd) {
            blocks += Sums()
            blockEnd = time + BLOCK_SECONDS
        }
        blocks.last().add(minOf(held, LONGEST_HOLD), amp, volt)
    }
    val xx = blocks.sumOf { it.xx }
    val xy = blocks.sumOf { it.xy }
    if (blocks.size < MIN_BLOCKS || !(sqrt(xx / blocks.sumOf { it.weight }) >= MIN_DEVIATION)) return null
    val slopes = blocks.map { (xy - it.xy) / (xx - it.xx) }
    val mean = slopes.average()
    val error = sqrt((slopes.size - 1.0) / slopes.size * slopes.sumOf { (it - mean) * (it - mean) })
    val found = Resistance(-MILLI * xy / xx, MILLI * error * quantile95(blocks.size - 1))
    return found.takeIf { it.milliohms.isFinite() && it.uncertainty < it.milliohms * MAX_UNCERTAINTY }
}

/**
 * Returns the number of standard errors on both sides that include 95 % of the values. It is Student's t for [degrees] of freedom, by the
 * expansion in Abramowitz and Stegun, 26.7.5.
 */
internal fun quantile95(degrees: Int): Double {
    // The expansion is for more.
    if (degrees <= FEW_DEGREES.size) return FEW_DEGREES[degrees - 1]
    val n = degrees.toDouble()
    return NORMAL95 + 2.3723 / n + 2.8225 / (n * n) + 2.5558 / (n * n * n)
}

/** Sums over one block, relative to its means, by Welford's updates. The small differences of large squares would lose their digits. */
private class Sums {
    var weight = 0.0
        private set
    var xx = 0.0
        private set
    var xy = 0.0
        private set
    private var meanX = 0.0
    private var meanY = 0.0

    fun add(held: Double, amp: Double, volt: Double) {
        weight += held
        val x = amp - meanX
        meanX += x * held / weight
        xx += held * x * (amp - meanX)
        meanY += (volt - meanY) * held / weight
        xy += held * x * (volt - meanY)
    }
}

private const val MILLI = 1000.0
internal const val NORMAL95 = 1.95996
private val FEW_DEGREES = listOf(12.706, 4.303)

/** The voltage, in V, below which a sample does not count. Libraries log 0 until they have measured one. */
internal const val MIN_VOLTS = 1.0
private const val BLOCK_SECONDS = 10.0
private const val MIN_BLOCKS = 4

/** A value that was not logged for this long is not known. */
private const val LONGEST_HOLD = 1.0

/** A share of the resistance: a worn battery has a third more than a new one. */
private const val MAX_UNCERTAINTY = 0.2

/** The minimum variation of the current, in amperes. */
private const val MIN_DEVIATION = 15.0
