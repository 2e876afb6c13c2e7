package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs

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
