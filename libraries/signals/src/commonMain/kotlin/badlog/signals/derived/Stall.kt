package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs

/**
 * Returns 1 at those [times] at which something that should turn does not, otherwise 0. It is 1 while it hardly turns ([speeds] below 4 %
 * of its usual speed) and its [current] is high: at least half of its maximum, as much as it mostly takes while it turns, and [least] A.
 * Something that never turned has no usual speed: it gives 0. So does exactly the current with which it still turned, since a device
 * without power leaves its last values in the log.
 *
 * A mechanism that holds a game piece stands under power, too. Its program then lowers the output, so times with a lowered output do not
 * count. If [outputs] is null because none are logged, something that stands more than once and turns in between does not count as blocked.
 */
fun stall(times: DoubleArray, speeds: DoubleArray, current: DoubleArray, least: Double, outputs: DoubleArray? = null): Series {
    val turning = TURNING * quantile(DoubleArray(times.size) { abs(speeds[it]) }, 0.98)
    fun whileTurning(values: DoubleArray, share: Double) =
        quantile(DoubleArray(times.size) { if (abs(speeds[it]) > turning) abs(values[it]) else Double.NaN }, share)
    val usual = whileTurning(current, 0.9)
    val driven = outputs?.let { LOWERED * whileTurning(it, 0.5) } ?: 0.0
    val hard = maxOf(0.5 * quantile(DoubleArray(times.size) { abs(current[it]) }, 0.995), least)
    val stalled = DoubleArray(times.size)
    var isOld = false
    var since = Double.NaN
    var standings = 0
    for (at in times.indices) {
        isOld = at > 0 && current[at] == current[at - 1] && (isOld || abs(speeds[at - 1]) > turning)
        if (abs(speeds[at]) > turning) since = Double.NaN
        val isHard = abs(current[at]) >= hard && !(abs(current[at]) < usual) && !isOld
        if (isHard && turning > 0 && abs(speeds[at]) < 0.2 * turning && !(outputs != null && abs(outputs[at]) < driven)) {
            stalled[at] = 1.0
            if (since.isNaN()) since = times[at]
            if (times[at] - since >= HELD_SECONDS) {
                standings++
                since = Double.POSITIVE_INFINITY
            }
        }
    }
    return Series(times, if (standings > 1 && outputs == null) DoubleArray(times.size) else stalled)
}

/** The share of its usual speed at which something clearly turns. */
private const val TURNING = 0.2

/** Of the output with which it turns. */
private const val LOWERED = 0.75
private const val HELD_SECONDS = 1.0
