package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs
import kotlin.math.sign

/**
 * Returns by how much the wheels gain speed faster than the robot does, in m/s², over [WINDOW_SECONDS] up to each time; 0 while they
 * brake or follow. [forward] and [left] are the speeds of the wheels along and across the robot in m/s, [heading] its heading in rad, and
 * [acceleration] what an accelerometer measured along the robot, in m/s². A robot that turns while it moves aside gains speed along
 * itself that no accelerometer feels. Nothing if the speeds change more seldom than [SELDOM_SECONDS]: then a step of them is older than
 * the acceleration that it is compared with.
 */
fun wheelSlip(times: DoubleArray, forward: DoubleArray, left: DoubleArray, heading: DoubleArray, acceleration: DoubleArray): Series {
    if (!(stepOf(times, forward) < SELDOM_SECONDS)) return Series(DoubleArray(0), DoubleArray(0))
    val gained = DoubleArray(times.size)
    for (i in 1 until times.size) {
        val seconds = times[i] - times[i - 1]
        val felt = acceleration[i] * seconds + (heading[i] - heading[i - 1]) * left[i]
        gained[i] = gained[i - 1] + if (felt.isFinite() && seconds < 0.1) felt else 0.0
    }
    return Series(
        times,
        DoubleArray(times.size) { i ->
            val first = indexBefore(times, i, WINDOW_SECONDS)
            val seconds = times[i] - times[first]
            val faster = forward[i] - forward[first]
            val slip = if (seconds < WINDOW_SECONDS / 2) 0.0 else (faster - (gained[i] - gained[first])) / seconds
            val isGaining = faster != 0.0 && sign(faster) == sign(forward[i]) && abs(forward[i]) > abs(forward[first])
            if (isGaining && sign(slip) == sign(forward[i])) abs(slip) else 0.0
        },
    )
}

/**
 * Returns [wheelSlip] of a tank drive, whose two sides have [speeds]; [isInMeters] if those are in m/s, otherwise their unit is found by the
 * [acceleration]. No samples if it cannot be found.
 */
internal fun slipOfSides(times: DoubleArray, speeds: List<DoubleArray>, acceleration: DoubleArray, isInMeters: Boolean): Series {
    val (one, other) = speeds
    // One of two sides may be mounted the other way round.
    val way = if (!isInMeters && correlation(one, other) < 0) -1.0 else 1.0
    val forward = DoubleArray(times.size) { (one[it] + way * other[it]) / 2 }
    val meters = (if (isInMeters) 1.0 else metersOf(times, forward, acceleration)) ?: return Series(DoubleArray(0), DoubleArray(0))
    val still = DoubleArray(times.size)
    return wheelSlip(times, scaled(forward, meters), still, still, acceleration)
}

/**
 * Returns how many m/s the robot makes of one unit of [speed], that of its wheels or motors along it, so that it gains speed as
 * [acceleration] says, in m/s²: the median over stretches of a second in which it gains or loses much. Slipping wheels have their grip
 * again after most of such stretches. Null if there are too few.
 */
internal fun metersOf(times: DoubleArray, speed: DoubleArray, acceleration: DoubleArray): Double? {
    val gained = DoubleArray(times.size)
    for (i in 1 until times.size) {
        val felt = acceleration[i] * (times[i] - times[i - 1])
        gained[i] = gained[i - 1] + if (felt.isFinite()) felt else 0.0
    }
    val top = quantile(DoubleArray(times.size) { abs(speed[it]) }, 0.98)
    val ratios = times.indices.mapNotNull { i ->
        val first = indexBefore(times, i, FIT_SECONDS)
        val faster = speed[i] - speed[first]
        if (abs(faster) > MUCH * top) (gained[i] - gained[first]) / faster else null
    }
    return if (ratios.size < LEAST_FITS) null else quantile(ratios.toDoubleArray(), 0.5)
}

/** Returns the usual time from one change of [speed] to the next while it changes; NaN if it never does. */
private fun stepOf(times: DoubleArray, speed: DoubleArray): Double {
    val changed = (1 until times.size).filter { speed[it] != speed[it - 1] }
    return quantile(DoubleArray(maxOf(0, changed.size - 1)) { times[changed[it + 1]] - times[changed[it]] }, 0.5)
}

private const val WINDOW_SECONDS = 0.12
private const val SELDOM_SECONDS = 0.035
private const val FIT_SECONDS = 1.0
private const val MUCH = 0.5
private const val LEAST_FITS = 200
