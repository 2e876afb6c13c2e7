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
 * A mechanism that is driven both ways without turning in between counts in any case: a held piece moves when it is pushed out, and a current limit
 * lowers the output of a blocked motor.
 */
fun stall(times: DoubleArray, speeds: DoubleArray, current: DoubleArray, least: Double, outputs: DoubleArray? = null): Series {
    val turning = TURNING * quantile(DoubleArray(times.size) { abs(speeds[it]) }, 0.98)
    fun whileTurning(values: DoubleArray, share: Double) =
        quantile(DoubleArray(times.size) { if (abs(speeds[it]) > turning) abs(values[it]) else Double.NaN }, share)
    val usual = whileTurning(current, 0.9)
    val driven = outputs?.let { LOWERED * whileTurning(it, 0.5) } ?: 0.0
    val hard = maxOf(0.5 * quantile(DoubleArray(times.size) { abs(current[it]) }, 0.995), least)
    val stalled = DoubleArray(times.size)
    val bothWays = BothWays(times)
    var isOld = false
    var since = Double.NaN
    var standings = 0
    for (at in times.indices) {
        isOld = at > 0 && current[at] == current[at - 1] && (isOld || abs(speeds[at - 1]) > turning)
        if (abs(speeds[at]) > turning) since = Double.NaN
        val still = STILL * turning
        if (abs(speeds[at]) >= still) bothWays.turns()
        val isHard = abs(current[at]) >= hard && !isOld && turning > 0 && abs(speeds[at]) < still
        if (isHard) bothWays.stands(at, outputs?.get(at) ?: current[at])
        if (isHard && !(abs(current[at]) < usual) && !(outputs != null && abs(outputs[at]) < driven)) {
            stalled[at] = 1.0
            if (since.isNaN()) since = times[at]
            if (times[at] - since >= HELD_SECONDS) {
                standings++
                since = Double.POSITIVE_INFINITY
            }
        }
    }
    bothWays.turns()
    val isUsual = standings > 1 && outputs == null
    for (at in times.indices) {
        if (isUsual) stalled[at] = 0.0
        if (bothWays.isBlocked[at]) stalled[at] = 1.0
    }
    return Series(times, stalled)
}

/** Finds where something is driven each way for [EACH_WAY_SECONDS] without turning in between. */
private class BothWays(private val times: DoubleArray) {
    /** Whether something is driven at each time, and stands although it is driven the other way, too. */
    val isBlocked = BooleanArray(times.size)
    private val stood = ArrayList<Int>()
    private var forward = 0.0
    private var backward = 0.0

    fun turns() {
        if (minOf(forward, backward) >= EACH_WAY_SECONDS) for (at in stood) isBlocked[at] = true
        stood.clear()
        forward = 0.0
        backward = 0.0
    }

    /** Adds the sample [at], at which it stands although it is driven [way]. */
    fun stands(at: Int, way: Double) {
        val seconds = if (stood.lastOrNull() == at - 1) times[at] - times[at - 1] else 0.0
        if (way > 0) {
            forward += seconds
        } else if (way < 0) {
            backward += seconds
        }
        stood += at
    }
}

/** The share of its usual speed at which something clearly turns. */
private const val TURNING = 0.2

/** Of the speed at which it clearly turns. */
private const val STILL = 0.2

/** Of the output with which it turns. */
private const val LOWERED = 0.75
private const val HELD_SECONDS = 1.0
private const val EACH_WAY_SECONDS = 0.5
