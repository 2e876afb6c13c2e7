package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs

/**
 * Returns by how much a mechanism's [position] contradicts its limit switch, in percent of its [range]; otherwise 0. The error is a move
 * while the switch stays [pressed], counted from 0 again every [MOVE_SECONDS], since a sensor may drift farther in minutes. Or it is a jump
 * as the switch closes, by more than the position moved before: code that considers the switch the end of travel sets the position then.
 * All arrays have the same [times].
 */
fun switchError(times: DoubleArray, position: DoubleArray, pressed: DoubleArray, range: Double = rangeOf(position)): Series {
    val errors = DoubleArray(times.size)
    var low = 0.0
    var high = 0.0
    var since = Double.NEGATIVE_INFINITY
    for (i in 1 until times.size) {
        if (pressed[i] != 1.0 || !(range > 0)) continue
        val here = position[i]
        if (pressed[i - 1] != 1.0) {
            // Code may set the position to 0 in the same loop, or in the next.
            var jump = 0.0
            val first = maxOf(1, i - 1)
            val moved = if (first > 1) position[first - 1] - position[first - 2] else 0.0
            for (k in first..minOf(i + 2, times.lastIndex)) {
                if (times[k] - times[k - 1] < JUMP_SECONDS) jump = maxOf(jump, abs(position[k] - position[k - 1] - moved))
            }
            if (jump > JUMP_SHARE * range) errors[i] = 100 * jump / range
        }
        if (pressed[i - 1] != 1.0 || times[i] - since > MOVE_SECONDS) {
            since = times[i]
            low = here
            high = here
        }
        if (here < low) low = here
        if (here > high) high = here
        errors[i] = maxOf(errors[i], 100 * (high - low) / range)
    }
    return Series(times, errors)
}

/** Returns the range of a mechanism that was at [places]; extremes of short moments do not count. */
internal fun rangeOf(places: DoubleArray): Double = quantile(places, 0.995) - quantile(places, 0.005)

/**
 * Returns where a switch has been [pressed] for some samples. A device sends its switch and its position at different times, so the position that
 * comes with the switch may be an old one.
 */
fun longPressed(times: DoubleArray, pressed: DoubleArray): DoubleArray {
    var since = 0
    return DoubleArray(times.size) { i ->
        if (pressed[i] != 1.0) since = i + 1
        if (i - since >= OLD_SAMPLES) 1.0 else 0.0
    }
}

private const val MOVE_SECONDS = 20.0
private const val OLD_SAMPLES = 3
private const val JUMP_SECONDS = 0.1
private const val JUMP_SHARE = 0.12
