package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs
import kotlin.math.sign

/**
 * Returns whether something that should turn does not, at [times]: 1 while it hardly turns ([speeds] below 4 % of its usual speed) though
 * it is driven at least half as hard as it ever is ([drives]: current or output), otherwise 0. Something that never turned has no usual
 * speed: it gives 0.
 */
fun stall(times: DoubleArray, speeds: DoubleArray, drives: DoubleArray, leastDrive: Double): Series {
    val usual = quantile(DoubleArray(times.size) { abs(speeds[it]) }, 0.98)
    val most = quantile(DoubleArray(times.size) { abs(drives[it]) }, 0.995)
    val least = maxOf(0.5 * most, leastDrive)
    fun isStalled(at: Int) = abs(drives[at]) >= least && usual > 0 && abs(speeds[at]) < 0.04 * usual
    return Series(times, DoubleArray(times.size) { if (isStalled(it)) 1.0 else 0.0 })
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

/** More than friction alone takes. */
private const val PUSHING = 0.05
private const val JUST_SECONDS = 0.3
