package badlog.signals.derived

import kotlin.math.abs

/**
 * Returns the speed that a controller seems to hold at each of [times], for logs without a setpoint. It is the median of each stretch in which
 * [speed] stays near its mean, 0 elsewhere. A stretch in which the speed follows the [output] is not held by a controller, but by a driver or the
 * battery.
 */
fun heldSpeeds(times: DoubleArray, speed: DoubleArray, output: DoubleArray): DoubleArray {
    val top = quantile(DoubleArray(speed.size) { abs(speed[it]) }, 0.98)
    val held = DoubleArray(times.size)
    var i = 0
    while (i < times.size) {
        var mean = speed[i]
        var end = i + 1
        while (end < times.size && abs(speed[end] - mean) < NEAR * abs(mean)) mean += (speed[end] - mean) / (end++ - i + 1)
        val isLong = times[end - 1] - times[i] > MIN_SECONDS && abs(mean) > RUNNING * top
        if (isLong && (i until end).any { output[it] != output[i] } && correlation(speed, output, i, end) < FOLLOWS) {
            val level = quantile(speed.copyOfRange(i, end), 0.5)
            for (k in i until end) held[k] = level
        }
        i = end
    }
    return held
}

private const val RUNNING = 0.3
private const val NEAR = 0.15
private const val MIN_SECONDS = 2.0
private const val FOLLOWS = 0.5
