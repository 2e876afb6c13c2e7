package badlog.signals

import badlog.core.analysis.Series
import badlog.signals.derived.Quantity
import badlog.signals.derived.Side
import badlog.signals.derived.heldAt
import badlog.signals.derived.quantile
import badlog.signals.derived.scaled
import badlog.signals.derived.sideFriction
import badlog.signals.derived.timesOf
import kotlin.math.abs

/** What can be calculated of the two sides of a tank drive. */
internal fun sideSignals(robot: RobotParts): List<DerivedSignal> {
    val drive = robot.sides
    fun of(side: String, vararg quantities: Quantity) = quantities.firstNotNullOfOrNull { quantity ->
        drive.find { side in it.part && it.quantity == quantity }
    }
    val speeds = listOf("left", "right").map { of(it, Quantity.VELOCITY) ?: return emptyList() }
    val outputs = listOf("left", "right").map { of(it, Quantity.CURRENT, Quantity.VOLTAGE, Quantity.OUTPUT) ?: return emptyList() }
    return listOf(0, 1).map { at ->
        val topics = listOf(outputs[at], speeds[at], outputs[1 - at], speeds[1 - at]).map { it.signal.name }
        val side = listOf("left", "right")[at]
        val shown = topics + drive.filter { side in it.part && it.quantity == Quantity.CURRENT }.map { it.signal.name }
        DerivedSignal("side friction", "", speeds[at].label, shown) { samples ->
            val all = topics.map(samples::raw)
            val times = timesOf(all)
            val full = when (outputs[at].quantity) {
                // At its limit, a current takes about a quarter of the output.
                Quantity.CURRENT -> 4 * maxOf(amperesOf(all[0]), amperesOf(all[2]))

                Quantity.VOLTAGE -> 12.0

                else -> fullOf(all[0])
            }
            fun side(output: Int) = Side(scaled(all[output].heldAt(times), 1 / full), all[output + 1].heldAt(times))
            once(times, sideFriction(times, side(0), side(2)))
        }
    }
}

/** The current that a motor gets at most, but for moments. */
private fun amperesOf(current: Series) = quantile(DoubleArray(current.size) { abs(current.y[it]) }, 0.99).coerceAtLeast(1.0)
