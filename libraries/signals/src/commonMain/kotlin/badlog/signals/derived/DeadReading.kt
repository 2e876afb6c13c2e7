package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs

/**
 * Returns whether [measured] has jumped, faster than it ever moves, to a value that it keeps exactly since: 1 or 0. An absolute encoder
 * without a cable reads like that.
 */
fun deadReading(times: DoubleArray, measured: DoubleArray, isEnabled: BooleanArray): Series {
    val range = rangeOf(measured)
    fun step(at: Int) = abs(measured[at] - measured[at - 1])
    val speeds = DoubleArray(times.size) { i -> if (i == 0 || times[i] == times[i - 1]) 0.0 else step(i) / (times[i] - times[i - 1]) }
    val usual = quantile(DoubleArray(times.size) { if (speeds[it] > 0) speeds[it] else Double.NaN }, 0.98)
    var isDead = false
    return Series(
        times,
        DoubleArray(times.size) { i ->
            if (i > 0 && measured[i] != measured[i - 1]) isDead = step(i) > JUMP * range && speeds[i] > FASTER * usual
            if (isDead && isEnabled[i]) 1.0 else 0.0
        },
    )
}

private const val JUMP = 0.1
private const val FASTER = 2.5
