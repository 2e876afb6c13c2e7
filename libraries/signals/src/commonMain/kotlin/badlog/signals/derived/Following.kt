package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs
import kotlin.math.max
import kotlin.math.min
import kotlin.math.roundToLong
import kotlin.math.sign

/**
 * How a part follows its target.
 *
 * @param times the time of each sample.
 * @param target the target value at these times.
 * @param measured the measured value, in the same unit.
 * @param isEnabled whether the robot was enabled at these times.
 */
class Following(
    private val times: DoubleArray,
    private val target: DoubleArray,
    private val measured: DoubleArray,
    private val isEnabled: BooleanArray,
) {
    /** The range of targets while enabled; never 0. */
    val range: Double = spread()

    /** The time for which target and mode have been the same, at each sample. */
    private val age = DoubleArray(times.size)

    init {
        var since = 0
        for (i in times.indices) {
            val isSame = i > 0 && abs(target[i] - target[since]) <= SAME * range && isEnabled[i] == isEnabled[i - 1]
            if (!isSame) since = i
            age[i] = times[i] - times[since]
        }
    }

    /**
     * Returns whether it follows at all. If so, it came to within [tolerance] of the range to at least some of its targets, and to two of
     * five. Otherwise the two are in different units, or measure different things, as an angle of a drum does the height of its elevator.
     * Targets near 0 do not count, where anything that rests agrees.
     */
    private fun follows(tolerance: Double): Boolean {
        if (!(range > 0) || !(largest > 0)) return false
        val reached = HashMap<Long, Boolean>()
        for (i in times.indices) {
            // Not for a target that is missing, either.
            if (!isEnabled[i] || age[i] < STAYED_SECONDS || !(abs(target[i]) >= MIN_TARGET * largest)) continue
            val isThere = abs(target[i] - measured[i]) <= tolerance
            val kind = (target[i] / (MIN_TARGET * range)).roundToLong()
            reached[kind] = isThere || reached[kind] == true
        }
        return reached.values.count { it } >= maxOf(1.0, MIN_REACHED * reached.size)
    }

    private fun unlessUnrelated(tolerance: Double, samples: () -> Series): Series =
        if (follows(tolerance)) samples() else Series(DoubleArray(0), DoubleArray(0))

    private fun spreadOf(values: DoubleArray) = quantile(values, 0.99) - quantile(values, 0.01)

    private val largest by lazy { quantile(DoubleArray(times.size) { abs(target[it]) }, 0.99) }

    private fun spread(): Double {
        val used = DoubleArray(times.size) { if (isEnabled[it]) target[it] else Double.NaN }
        val spread = spreadOf(used)
        return if (spread > 0) spread else max(abs(quantile(used, 0.99)), Double.MIN_VALUE)
    }

    /**
     * Returns the least error of the last [STAYED_SECONDS], in percent of the range. NaN while it comes nearer to its target, and just after
     * the robot was enabled.
     */
    fun missed(): Series = unlessUnrelated(NEAR * range, ::away)

    /** Returns the same as [missed], also for a part that never moved. */
    fun missedOrStill(): Series = if (spreadOf(measured) < STILL * range) away() else missed()

    /** Returns the same as [missed] while the part does not move at all; NaN while it moves. */
    fun standingAway(): Series {
        val away = missed()
        val least = STILL * min(range, spreadOf(measured))
        return Series(away.x, DoubleArray(away.size) { if (peakToPeak(it, STAYED_SECONDS) < least) away.y[it] else Double.NaN })
    }

    private fun away(): Series {
        var enabledSince = 0
        return samples { i ->
            if (i > 0 && !isEnabled[i - 1]) enabledSince = i
            val first = indexBefore(times, i, STAYED_SECONDS)
            if (times[i] - times[enabledSince] < SETTLED_SECONDS || times[i] - times[first] < STAYED_SECONDS / 2) return@samples Double.NaN
            var least = Double.MAX_VALUE
            for (k in first..i) least = min(least, abs(target[k] - measured[k]))
            val toward = (measured[i] - measured[first]) * sign(target[i] - measured[i])
            if (toward > NEARER * range) Double.NaN else PERCENT * least / range
        }
    }

    /** Returns the shortfall from a constant target other than 0, in percent of the target. NaN while either changes. */
    fun shortfall(): Series = unlessUnrelated(ROUGHLY * largest) {
        samples { i ->
            val wanted = abs(target[i])
            if (age[i] < SPUN_UP_SECONDS || wanted < 0.3 * largest || peakToPeak(i, STEADY_SECONDS) > STEADY * wanted) {
                Double.NaN
            } else {
                // What hardly turns is switched off, or stuck, which currents show.
                (PERCENT * (wanted - measured[i] * sign(target[i])) / wanted).let { if (it > SWITCHED_OFF) Double.NaN else it }
            }
        }
    }

    /** Returns the distance beyond a target that has just changed, in percent of the step. */
    fun overshoot(): Series = unlessUnrelated(NEAR * range) {
        val beyond = DoubleArray(times.size) { Double.NaN }
        var before = Double.NaN
        var i = 0
        while (i < times.size) {
            val end = endOfStretch(i)
            val isLong = times[end - 1] - times[i] >= STEP_SECONDS
            if (isLong && isEnabled[i] && !before.isNaN()) {
                val step = target[i] - before
                if (abs(step) > MIN_STEP * range) {
                    for (k in i until end) beyond[k] = max(0.0, PERCENT * (measured[k] - target[i]) / step)
                }
            }
            if (isLong) before = if (isEnabled[i]) target[i] else Double.NaN
            i = end
        }
        Series(times, beyond)
    }

    /** Returns the peak-to-peak swing around a constant target, in percent of the target. NaN if the part does not swing. */
    fun swing(): Series = swings { abs(target[it]) }

    /** Returns the peak-to-peak swing of a position around a constant target, in percent of the range. NaN if it does not swing. */
    fun placeSwing(): Series {
        // Where there is hardly more than one target, noise is large beside their range.
        val whole = max(range, spreadOf(measured))
        return swings { whole }
    }

    private fun swings(whole: (Int) -> Double): Series {
        val swings = DoubleArray(times.size) { Double.NaN }
        var i = 0
        while (i < times.size) {
            val end = endOfStretch(i)
            if (isEnabled[i] && whole(i) > 0 && times[end - 1] - times[i] > SWING_SECONDS) swingsIn(i, end, whole(i), swings)
            i = end
        }
        return Series(times, swings)
    }

    private fun swingsIn(from: Int, until: Int, whole: Double, swings: DoubleArray) {
        val near = 0.25 * whole
        var start = from
        for (i in from until until) {
            if (abs(measured[i] - target[i]) > near) start = i + 1
            if (start > i || times[i] - times[start] < SWING_SECONDS) continue
            val first = indexBefore(times, i, SWING_SECONDS, start)
            val swing = turnsIn(first, i, whole)
            swings[i] = if (swing.isNaN() || isSmooth(first, i)) swing else Double.NaN
        }
    }

    /**
     * Returns whether the measurement changes little from one value to the next, beside all its changes. Noise does not, nor does a swing
     * with fewer than eight values in the log: they look the same.
     */
    private fun isSmooth(from: Int, to: Int): Boolean {
        val values = (from..to).filter { it == from || measured[it] != measured[it - 1] }.map { measured[it] }
        val mean = values.average()
        return values.zipWithNext { one, next -> (next - one) * (next - one) }.sum() < SMOOTH * values.sumOf { (it - mean) * (it - mean) }
    }

    /**
     * Returns the median size of the swings between two samples in percent of the [whole]. NaN unless they go to both sides of the target
     * in turn, and about as far. A wheel that loses speed with each shot is far below its target, and hardly above.
     */
    private fun turnsIn(from: Int, to: Int, whole: Double): Double {
        val wanted = target[to]
        val least = MIN_SWING / 2 * whole
        val sizes = ArrayList<Double>()
        val sums = doubleArrayOf(0.0, 0.0)
        var side = 0.0
        var extreme = 0.0
        for (i in from..to) {
            val off = measured[i] - wanted
            if (abs(off) < least) continue
            if (sign(off) != side) {
                if (side != 0.0) {
                    sizes += abs(extreme)
                    sums[if (side > 0) 1 else 0] += abs(extreme)
                }
                side = sign(off)
                extreme = off
            } else if (abs(off) > abs(extreme)) {
                extreme = off
            }
        }
        // Sides take turns, so their sums compare their sizes.
        val isEven = sums.min() > MIN_EVEN * sums.max()
        return if (sizes.size < MIN_TURNS || !isEven) Double.NaN else 2 * PERCENT * sizes.sorted()[sizes.size / 2] / whole
    }

    private fun endOfStretch(from: Int): Int {
        var end = from + 1
        while (end < times.size && age[end] > 0) end++
        return end
    }

    private fun peakToPeak(at: Int, seconds: Double): Double {
        var low = measured[at]
        var high = measured[at]
        var i = at
        while (i >= 0 && times[at] - times[i] <= seconds) {
            low = min(low, measured[i])
            high = max(high, measured[i])
            i--
        }
        return high - low
    }

    private fun samples(value: (Int) -> Double) = Series(times, DoubleArray(times.size) { if (isEnabled[it]) value(it) else Double.NaN })
}

private const val PERCENT = 100.0

// Of the range, or of the largest speed.
private const val NEAR = 0.1
private const val STILL = 0.01
private const val ROUGHLY = 0.4
private const val MIN_TARGET = 0.1
private const val MIN_REACHED = 0.4

// Targets that differ less are the same.
private const val SAME = 0.002
private const val SETTLED_SECONDS = 1.0
private const val STAYED_SECONDS = 0.4
private const val NEARER = 0.03
private const val SPUN_UP_SECONDS = 1.0
private const val STEADY_SECONDS = 0.4
private const val STEADY = 0.04
private const val SWITCHED_OFF = 60.0
private const val STEP_SECONDS = 0.6
private const val MIN_STEP = 0.25
private const val SWING_SECONDS = 2.0
private const val MIN_SWING = 0.012
private const val MIN_TURNS = 3

// 2 for noise, 0.6 for a sine with eight values.
private const val SMOOTH = 0.6
private const val MIN_EVEN = 0.4
