package badlog.viewer.draw.path

import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.signals.pose.Trail
import badlog.viewer.text.fixedText
import badlog.viewer.text.withUnit
import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.log10

/**
 * The straight line fitted to the samples of a trail by least squares.
 *
 * @property slope the increase of y per x.
 * @property offset the y at x = 0.
 * @property inverseSlope the increase of x per y, fitted the other way round: scattered samples have two such lines.
 */
internal class LineFit private constructor(val slope: Double, val offset: Double, private val inverseSlope: Double) {
    /**
     * Returns the result as text. For volts and amperes, on either axis, it is the resistance that causes the drop; otherwise the slope.
     */
    fun text(xUnit: String, yUnit: String): String = when {
        xUnit == "A" && yUnit == "V" -> resistanceText(-slope)
        xUnit == "V" && yUnit == "A" && inverseSlope.isFinite() -> resistanceText(-inverseSlope)
        else -> "Slope ${withUnit(roundedTo(slope), Units.ofDerivative(yUnit, xUnit))}"
    }

    private fun resistanceText(ohms: Double) = "Resistance ${withUnit(roundedTo(ohms * MILLI), "mΩ")}"

    // Three digits: scattered samples do not justify more.
    private fun roundedTo(value: Double) = fixedText(value, (2 - floor(log10(abs(value)))).coerceIn(0.0, MAX_DECIMALS).toInt())

    companion object {
        /** Returns the line through the samples of [trail] in [visible]; null if x hardly changes, or there are few samples. */
        fun of(trail: Trail, visible: Span): LineFit? {
            var count = 0
            var x = 0.0
            var y = 0.0
            eachIn(trail, visible) { i ->
                count++
                x += trail.x[i]
                y += trail.y[i]
            }
            if (count < MIN_POINTS) return null
            x /= count
            y /= count
            var xx = 0.0
            var xy = 0.0
            var yy = 0.0
            eachIn(trail, visible) { i ->
                xx += (trail.x[i] - x) * (trail.x[i] - x)
                xy += (trail.x[i] - x) * (trail.y[i] - y)
                yy += (trail.y[i] - y) * (trail.y[i] - y)
            }
            val slope = xy / xx
            return if (slope.isFinite()) LineFit(slope, y - slope * x, xy / yy) else null
        }

        private inline fun eachIn(trail: Trail, visible: Span, visit: (Int) -> Unit) {
            for (i in trail.startOf(visible) until trail.endOf(visible)) {
                if (trail.isPlace(i) && trail.times[i] in visible) visit(i)
            }
        }

        private const val MIN_POINTS = 3
        private const val MILLI = 1000.0
        private const val MAX_DECIMALS = 9.0
    }
}
