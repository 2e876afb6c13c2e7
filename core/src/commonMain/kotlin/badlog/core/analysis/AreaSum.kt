package badlog.core.analysis

import kotlin.math.abs

/**
 * The area under samples that are added one by one; each holds until the next. Neumaier's compensation (1974) ensures that a million small
 * steps lose nothing.
 */
public class AreaSum {
    private var sum = 0.0
    private var compensation = 0.0
    private var lastX = Double.NaN
    private var lastY = Double.NaN

    /** The area so far. */
    public val value: Double get() = sum + compensation

    /** Adds the sample ([x], [y]), and the area since the previous sample if that has a value and is not later. */
    public fun add(x: Double, y: Double) {
        holdUntil(x)
        lastX = x
        lastY = y
    }

    /** Ends the area at [x]: the last sample holds until there. */
    public fun holdUntil(x: Double) {
        if (x >= lastX) addArea((x - lastX) * lastY)
        lastX = Double.NaN
    }

    internal fun addArea(area: Double) {
        if (!area.isFinite()) return
        val next = sum + area
        compensation += if (abs(sum) >= abs(area)) (sum - next) + area else (area - next) + sum
        sum = next
    }
}
