package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.round

/**
 * Returns how far the angle of module [at] of a drive is off its target at [times], in degrees. The worst error of the other modules at
 * that moment is subtracted. A module that runs backward instead of turning by half a turn follows its target. NaN while the module should
 * stand, or while the robot is not enabled.
 */
fun moduleAngleError(
    at: Int,
    times: DoubleArray,
    angles: List<DoubleArray>,
    targets: List<DoubleArray>,
    speeds: List<DoubleArray>,
    isEnabled: BooleanArray,
): Series {
    // While nothing turns, nothing lags; a log of changes has no samples then, either.
    val turning = times.indices.filter { i -> i == 0 || angles.any { it[i] != it[i - 1] } || targets[at][i] != targets[at][i - 1] }
    val steps = DoubleArray(maxOf(0, turning.size - 1)) { times[turning[it + 1]] - times[turning[it]] }
    // An angle that comes seldom is an old one: it followed an earlier target.
    val age = quantile(steps, 0.5).let { if (it > SELDOM) 2 * it else 0.0 }
    return Series(
        DoubleArray(turning.size) { times[turning[it]] },
        DoubleArray(turning.size) { k ->
            val i = turning[k]
            if (!isEnabled[i] || !isDriving(speeds[at][i])) {
                Double.NaN
            } else {
                val since = indexBefore(times, i, age)
                val errors = angles.indices.map { module -> (since..i).minOf { halfTurnError(targets[module][it] - angles[module][i]) } }
                errors[at] - errors.filterIndexed { index, _ -> index != at }.max()
            }
        },
    )
}

/** Returns whether the [angles] of modules change less often than every second loop while they turn. */
internal fun isSeldom(times: DoubleArray, angles: List<DoubleArray>): Boolean {
    val turning = (1 until times.size).filter { i -> angles.any { it[i] != it[i - 1] } }
    return quantile(DoubleArray(maxOf(0, turning.size - 1)) { times[turning[it + 1]] - times[turning[it]] }, 0.5) > SELDOM_CHANGES
}

/** Returns the size of an angle of [radians] modulo a half turn, in degrees, 0 to 90. */
internal fun halfTurnError(radians: Double): Double = abs(radians - PI * round(radians / PI)) * 180 / PI

/** Returns whether a module with the target [speed], in m/s, has to keep its angle. */
internal fun isDriving(speed: Double): Boolean = abs(speed) >= MOVING

/** In s. */
private const val SELDOM = 0.05
private const val SELDOM_CHANGES = 0.04

/** In m/s. */
private const val MOVING = 0.3
