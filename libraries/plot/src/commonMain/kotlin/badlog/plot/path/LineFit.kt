package badlog.plot.path

import badlog.analysis.Span
import badlog.analysis.Units
import badlog.plot.text.fixedText
import badlog.plot.text.withUnit
import badlog.rules.path.Trail
import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.log10

/**
 * The straight line nearest to the samples of a trail, by least squares.
 *
 * @property slope how much y grows with x.
 * @property offset what y is where x is 0.
 */
public class LineFit private constructor(public val slope: Double, public val offset: Double) {
    /** What it says: of volts over amperes the resistance that makes them fall, else the slope. */
    public fun text(xUnit: String, yUnit: String): String = if (xUnit == "A" && yUnit == "V") {
        "Resistance ${withUnit(roundedTo(-slope * MILLI), "mΩ")}"
    } else {
        "Slope ${withUnit(roundedTo(slope), Units.ofDerivative(yUnit, xUnit))}"
    }

    // Three digits: no more are known of what scatters.
    private fun roundedTo(value: Double) = fixedText(value, (2 - floor(log10(abs(value)))).coerceIn(0.0, MAX_DECIMALS).toInt())

    public companion object {
        /** The line of those samples of [trail] that [visible] has; null where x hardly changes, or they are few. */
        public fun of(trail: Trail, visible: Span): LineFit? {
            var count = 0
            var x = 0.0
            var y = 0.0
            eachIn(trail, visible) { i ->
                count++
                x += trail.x[i]
                y += trail.y[i]
            }
            if (count < FEWEST) return null
            x /= count
            y /= count
            var xx = 0.0
            var xy = 0.0
            eachIn(trail, visible) { i ->
                xx += (trail.x[i] - x) * (trail.x[i] - x)
                xy += (trail.x[i] - x) * (trail.y[i] - y)
            }
            val slope = xy / xx
            return if (slope.isFinite()) LineFit(slope, y - slope * x) else null
        }

        private inline fun eachIn(trail: Trail, visible: Span, visit: (Int) -> Unit) {
            for (i in trail.startOf(visible) until trail.endOf(visible)) {
                if (trail.isPlace(i) && trail.times[i] in visible) visit(i)
            }
        }

        private const val FEWEST = 3
        private const val MILLI = 1000.0
        private const val MAX_DECIMALS = 9.0
    }
}
