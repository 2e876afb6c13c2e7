package badlog.signals.derived

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sin

/**
 * Returns the speed of each wheel of a swerve drive as a share of the others' average. It is 1 in a healthy drive. A wheel that does not point where
 * its encoder says slides, and turns slower than the others. Null if there is too little straight driving to tell.
 *
 * Only straight driving counts, in which all wheels point the same way: then all have to turn equally fast, wherever they are.
 */
fun moduleSpeedShares(speeds: List<DoubleArray>, angles: List<DoubleArray>): DoubleArray? {
    val top = quantile(DoubleArray(speeds[0].size) { abs(speeds[0][it]) }, 0.98)
    val own = List(speeds.size) { ArrayList<Double>() }
    for (i in speeds[0].indices) {
        val x = speeds.indices.map { speeds[it][i] * cos(angles[it][i]) }
        val y = speeds.indices.map { speeds[it][i] * sin(angles[it][i]) }
        val size = speeds.indices.map { hypot(x[it], y[it]) }
        if (!(size.min() > 0.3 * top)) continue
        val spread = speeds.indices.maxOf { k -> abs(kotlin.math.atan2(x[0] * y[k] - y[0] * x[k], x[0] * x[k] + y[0] * y[k])) }
        if (spread > STRAIGHT) continue
        for (k in speeds.indices) own[k] += size[k] / (size.sum() - size[k]) * (size.size - 1)
    }
    if (own[0].size < MIN_SAMPLES) return null
    return DoubleArray(speeds.size) { quantile(own[it].toDoubleArray(), 0.5) }
}

/** Directions that differ less are the same, in rad. */
private const val STRAIGHT = 4 * PI / 180
private const val MIN_SAMPLES = 150
