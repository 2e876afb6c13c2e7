package badlog.analysis

import kotlin.math.abs

/**
 * The area under samples that come one by one, by the trapezoid rule, summed with Neumaier's compensation (1974), so that a
 * million small steps lose nothing.
 */
public class TrapezoidSum {
    private var sum = 0.0
    private var compensation = 0.0
    private var lastX = Double.NaN
    private var lastY = Double.NaN

    /** The area so far. */
    public val value: Double get() = sum + compensation

    /** Adds the sample ([x], [y]); the area before it counts when the sample before it has a value and is not later. */
    public fun add(x: Double, y: Double) {
        val area = (x - lastX) * (y / 2 + lastY / 2)
        if (x >= lastX && area.isFinite()) {
            val next = sum + area
            compensation += if (abs(sum) >= abs(area)) (sum - next) + area else (area - next) + sum
            sum = next
        }
        lastX = x
        lastY = y
    }

    /** Says that samples are left out here, so that those before and after are not neighbors. */
    public fun interrupt() {
        lastX = Double.NaN
    }
}
