package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs
import kotlin.math.sign

/**
 * Returns whether something that should turn does not, at [times]: 1 while it hardly turns ([speeds] below 4 % of its usual speed) though
 * it takes at least half as much [current] as it ever does, and [least] A, otherwise 0. Something that never turned has no usual speed: it
 * gives 0. So does exactly the current with which it still turned, since a device without power leaves its last values in the log.
 */
fun stall(times: DoubleArray, speeds: DoubleArray, current: DoubleArray, least: Double): Series {
    val usual = quantile(DoubleArray(times.size) { abs(speeds[it]) }, 0.98)
    val hard = maxOf(0.5 * quantile(DoubleArray(times.size) { abs(current[it]) }, 0.995), least)
    val stalled = DoubleArray(times.size)
    var isOld = false
    for (at in times.indices) {
        val speed = abs(speeds[at])
        isOld = at > 0 && current[at] == current[at - 1] && (isOld || abs(speeds[at - 1]) > TURNING * usual)
        if (abs(current[at]) >= hard && usual > 0 && speed < 0.04 * usual && !isOld) stalled[at] = 1.0
    }
    return Series(times, stalled)
}

/**
 * Returns whether something that should turn does not, at [times], where only the [outputs] of its motor are logged, of which [full] is all: 1
 * while it hardly turns though its motor pushes, and its output broke down from what it usually is as it stopped. A controller that limits
 * its current does that to a motor that is blocked. An output that is constant is none that a limit makes, but a program that holds
 * something with little power.
 */
fun limitedStall(times: DoubleArray, speeds: DoubleArray, outputs: DoubleArray, full: Double): Series {
    val usual = quantile(DoubleArray(times.size) { abs(speeds[it]) }, 0.98)
    val most = quantile(DoubleArray(times.size) { abs(outputs[it]) }, 0.995)
    fun isStill(at: Int) = usual > 0 && abs(speeds[at]) < 0.04 * usual && abs(outputs[at]) > PUSHING * full
    val stalled = DoubleArray(times.size)
    var i = 0
    while (i < times.size) {
        if (!isStill(i)) {
            i++
            continue
        }
        var end = i
        while (end < times.size && isStill(end) && sign(outputs[end]) == sign(outputs[i])) end++
        val before = indexBefore(times, i, JUST_SECONDS)
        val brokeDown = (before..i).any { abs(outputs[it]) > 0.5 * most && sign(outputs[it]) == sign(outputs[i]) }
        val isLimited = (i + 2 until end).any { outputs[it] != outputs[it - 1] } && abs(outputs[(i + end) / 2]) < 0.5 * most
        if (brokeDown && isLimited) for (k in i until end) stalled[k] = 1.0
        i = end
    }
    return Series(times, stalled)
}

/** The share of its usual speed at which something clearly turns. */
private const val TURNING = 0.2

/** More than friction alone takes. */
private const val PUSHING = 0.05
private const val JUST_SECONDS = 0.3
