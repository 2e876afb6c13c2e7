package badlog.signals

import badlog.core.analysis.Series
import badlog.signals.derived.Following
import badlog.signals.derived.heldAt
import badlog.signals.derived.quantile
import kotlin.math.abs

/** Returns the signals that show how [part] follows a target position; [topics] show the part. */
internal fun placeSignals(part: String, topics: List<String>, following: (NamedSamples) -> Following): List<DerivedSignal> = listOf(
    DerivedSignal("setpoint error", "%", part, topics) { following(it).missed() },
    DerivedSignal("overshoot", "%", part, topics) { following(it).overshoot() },
    DerivedSignal("position swing", "%", part, topics) { following(it).placeSwing() },
)

/** Returns the signals that show how [part] follows a target speed; [topics] show the part. */
internal fun speedSignals(part: String, topics: List<String>, following: (NamedSamples) -> Following): List<DerivedSignal> = listOf(
    DerivedSignal("speed shortfall", "%", part, topics) { following(it).shortfall() },
    DerivedSignal("speed swing", "%", part, topics) { following(it).swing() },
)

/**
 * Returns the absolute [output] as a fraction of [full] output while a part misses its target, otherwise 0. It misses its target while
 * [missed] is above [AWAY_PERCENT].
 */
internal fun effort(missed: Series, output: Series, full: Double): Series {
    val held = output.heldAt(missed.x)
    return Series(missed.x, DoubleArray(missed.size) { if (missed.y[it] > AWAY_PERCENT) abs(held[it]) / full else 0.0 })
}

/**
 * Returns 1 while a part stands away from its target although it is driven, otherwise 0. Its error [away] is then above [AWAY_PERCENT], and
 * its [current] at least [least] A and half of its maximum. A part that only holds its place is near its target.
 */
internal fun heldBack(away: Series, current: Series, least: Double): Series {
    val held = current.heldAt(away.x)
    val hard = maxOf(least, 0.5 * quantile(DoubleArray(held.size) { abs(held[it]) }, 0.995))
    return Series(away.x, DoubleArray(away.size) { if (away.y[it] > AWAY_PERCENT && abs(held[it]) >= hard) 1.0 else 0.0 })
}

/** Returns the value of full output in [output]: 100 if it is logged in percent, otherwise 1. */
internal fun fullOf(output: Series): Double = if (output.y.any { it > 2 || it < -2 }) 100.0 else 1.0

/**
 * Returns [value], which describes the whole log, as one sample at the first of [times]. Empty if [value] is null or there are no times.
 */
internal fun once(times: DoubleArray, value: Double?): Series = if (value == null || times.isEmpty()) {
    Series(DoubleArray(0), DoubleArray(0))
} else {
    Series(doubleArrayOf(times[0]), doubleArrayOf(value))
}

/** In percent of the range. */
private const val AWAY_PERCENT = 12.0
