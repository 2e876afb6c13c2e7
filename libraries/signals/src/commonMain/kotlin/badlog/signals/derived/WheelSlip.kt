package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs
import kotlin.math.sign

/**
 * Returns by how much the wheels gain speed faster than the robot does, in m/s², over [WINDOW_SECONDS] up to each time; 0 while they
 * brake or follow. [forward] and [left] are the speeds of the wheels along and across the robot in m/s, [heading] its heading in rad, and
 * [acceleration] what an accelerometer measured along the robot, in m/s². A robot that turns while it moves aside gains speed along
 * itself that no accelerometer feels.
 */
fun wheelSlip(times: DoubleArray, forward: DoubleArray, left: DoubleArray, heading: DoubleArray, acceleration: DoubleArray): Series {
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

private const val WINDOW_SECONDS = 0.12
