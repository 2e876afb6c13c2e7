package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs

/**
 * Returns the drift of a mechanism's sensor [moved] from its motor's position [turned], in percent of the mechanism's range. It is 0 while one ratio
 * holds for both. It counts from the first time the robot was enabled, since code may set either position before. All arrays have the same [times].
 * Empty if the motor hardly moved, or if the two were never coupled. While the motor's position is still exactly the one with which both agreed, it may
 * only not be read.
 */
fun couplingError(times: DoubleArray, turned: DoubleArray, moved: DoubleArray, isEnabled: BooleanArray): Series {
    val range = quantile(moved, 0.98) - quantile(moved, 0.02)
    val first = isEnabled.indexOfFirst { it }
    val ratio = if (first < 0) null else ratioOf(turned, moved, first)
    if (ratio == null || !(range > 0)) return Series(DoubleArray(0), DoubleArray(0))
    val rest = DoubleArray(times.size) { moved[it] - ratio * turned[it] }
    val until = times.indices.firstOrNull { times[it] > times[first] + START_SECONDS } ?: times.size
    val start = quantile(rest.copyOfRange(first, until), 0.5)
    var isMoved = false
    return Series(
        times,
        DoubleArray(times.size) { i ->
            val error = if (i < first) 0.0 else 100 * (rest[i] - start) / range
            isMoved = abs(error) >= AGREEING_PERCENT && (isMoved || (i > 0 && turned[i] != turned[i - 1]))
            if (isMoved) error else 0.0
        },
    )
}

/**
 * Returns 1 at those [times] at which [moved] stands exactly still although [turned] moves while the robot is enabled, otherwise 0.
 * [turned] must have moved by more than a twentieth of its range since [moved] last changed. Two devices report at different times, so
 * movements of [turned] just after that do not count. Nor does a value of [turned] that reverts at once: it was misread.
 */
fun frozenWhileTurning(times: DoubleArray, turned: DoubleArray, moved: DoubleArray, isEnabled: BooleanArray): Series {
    val range = quantile(turned, 0.98) - quantile(turned, 0.02)
    var low = Double.NaN
    var high = Double.NaN
    var since = 0
    var place = turned.firstOrNull() ?: Double.NaN
    return Series(
        times,
        DoubleArray(times.size) { i ->
            if (i > 0 && moved[i] != moved[i - 1]) since = i
            if (!isTakenBack(times, turned, i, place, FROZEN_SHARE * range)) place = turned[i]
            if (times[i] - times[since] < LATE_SECONDS || low.isNaN()) {
                low = place
                high = place
            }
            if (place < low) low = place
            if (place > high) high = place
            if (isEnabled[i] && range > 0 && high - low > FROZEN_SHARE * range) 1.0 else 0.0
        },
    )
}

/** Returns whether [values] leaves [before] at [at] by more than [least], and is nearly back within [MISREAD_SECONDS]. */
private fun isTakenBack(times: DoubleArray, values: DoubleArray, at: Int, before: Double, least: Double): Boolean {
    val jump = abs(values[at] - before)
    if (!(jump > least)) return false
    var next = at + 1
    while (next < times.size && times[next] <= times[at] + MISREAD_SECONDS) {
        if (abs(values[next] - before) < jump * NEARLY_BACK) return true
        next++
    }
    return false
}

/** Returns whether one ratio holds for [turned] and [moved] over the first steps after the robot was first enabled. */
internal fun areCoupled(turned: DoubleArray, moved: DoubleArray, isEnabled: BooleanArray): Boolean {
    val first = isEnabled.indexOfFirst { it }
    return first >= 0 && ratioOf(turned, moved, first) != null
}

/**
 * Returns the only one of [motors] that is coupled to [moved]; null if there is none. All are positions at [times]. A coupled motor keeps
 * one ratio to [moved], and no other motor does, in some stretch of the first [KNOWN_SECONDS] after the robot was first enabled in which
 * [moved] moves far. Also null if [moved] counts from 0 again after each turn.
 */
internal fun coupledMotor(times: DoubleArray, motors: List<DoubleArray>, moved: DoubleArray, isEnabled: BooleanArray): DoubleArray? {
    if (turnsAround(moved)) return null
    val range = quantile(moved, 0.98) - quantile(moved, 0.02)
    val first = isEnabled.indexOfFirst { it }
    if (first < 0) return null
    var from = first
    while (from < times.size && times[from] < times[first] + KNOWN_SECONDS) {
        var until = from
        while (until < times.size && times[until] < times[from] + STRETCH_SECONDS) until++
        val stretch = moved.copyOfRange(from, until)
        if (quantile(stretch, 0.98) - quantile(stretch, 0.02) > FAR * range) {
            val fitting = motors.filter { abs(correlation(it, moved, from, until)) > COUPLED }
            if (fitting.size == 1) return fitting[0]
        }
        from = until
    }
    return null
}

/** Returns whether a sensor that reads [turns] counts from 0 again after each turn. */
internal fun turnsAround(turns: DoubleArray): Boolean =
    (1 until turns.size).count { abs(turns[it] - turns[it - 1]) > HALF_TURN } > FEW_TURNS

/**
 * Returns the median movement of the mechanism per turn of the motor, over its first steps. Later damage does not count. Null if there are
 * too few, or if they differ: then nothing couples the two.
 */
private fun ratioOf(turned: DoubleArray, moved: DoubleArray, first: Int): Double? {
    val range = quantile(moved, 0.98) - quantile(moved, 0.02)
    if (!(range > 0)) return null
    val ratios = ArrayList<Double>()
    var last = first
    for (i in first until turned.size) {
        if (turned[last].isNaN() || moved[last].isNaN()) last = i
        val step = moved[i] - moved[last]
        if (abs(step) < STEP_SHARE * range) continue
        if (turned[i] != turned[last]) ratios += step / (turned[i] - turned[last])
        last = i
        if (ratios.size == FIRST_STEPS) break
    }
    if (ratios.size < MIN_STEPS) return null
    val all = ratios.toDoubleArray()
    val ratio = quantile(all, 0.5)
    val isOne = quantile(all, 0.75) - quantile(all, 0.25) < ONE_RATIO * abs(ratio)
    return ratio.takeIf { it != 0.0 && it.isFinite() && isOne }
}

private const val AGREEING_PERCENT = 3.0
private const val HALF_TURN = 0.5
private const val FEW_TURNS = 3
private const val KNOWN_SECONDS = 60.0
private const val STRETCH_SECONDS = 6.0
private const val FAR = 0.25
private const val COUPLED = 0.998
private const val START_SECONDS = 8.0
private const val FROZEN_SHARE = 0.05
private const val STEP_SHARE = 0.05
private const val FIRST_STEPS = 60
private const val MIN_STEPS = 15
private const val ONE_RATIO = 0.5
private const val LATE_SECONDS = 0.05

/** No motor goes a twentieth of its range and back within that time, in s. */
private const val MISREAD_SECONDS = 0.05
private const val NEARLY_BACK = 0.25
