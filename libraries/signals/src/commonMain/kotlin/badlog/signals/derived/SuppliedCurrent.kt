package badlog.signals.derived

import kotlin.math.abs
import kotlin.math.sign

/**
 * Returns the current that a motor takes from the battery: the [current] through its windings times its [output]. Only the size of the current is
 * used, since some controllers report no sign. The result is negative while the motor brakes: while its output is less than it usually is at its
 * [speed].
 */
fun suppliedCurrent(current: DoubleArray, output: DoubleArray, speed: DoubleArray): DoubleArray {
    val top = quantile(DoubleArray(speed.size) { abs(speed[it]) }, 0.98)
    val usual = quantile(
        DoubleArray(speed.size) { if (abs(speed[it]) > RUNNING * top && speed[it] != 0.0) output[it] / speed[it] else Double.NaN },
        0.5,
    )
    return DoubleArray(current.size) { i ->
        val size = abs(current[i] * output[i])
        val isBraking = usual.isFinite() && output[i] / usual * sign(speed[i]) < abs(speed[i])
        if (isBraking) -size else size
    }
}

private const val RUNNING = 0.3
