package badlog.expression

import badlog.analysis.Units
import kotlin.math.abs
import kotlin.math.round

/** How much of x a second is, where x is a time in [unit]; 1 where it has none. */
internal fun perSecond(unit: String): Double {
    val seconds = Units.secondsIn(unit) ?: 1.0
    return if (seconds < 1) round(1 / seconds) else 1 / seconds
}

/**
 * How much a stretch of [length] up to [time] may seem longer than it is: times are rounded to decimals in a file, and 0.5 after
 * 9.52 is 10.02, whatever binary fractions make of it.
 */
internal fun slack(length: Double, time: Double): Double = length * 1e-9 + abs(time) * 1e-15
