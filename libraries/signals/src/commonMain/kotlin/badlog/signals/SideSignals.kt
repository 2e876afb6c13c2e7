package badlog.signals

import badlog.core.analysis.Series
import badlog.signals.derived.PartTopic
import badlog.signals.derived.Quantity
import badlog.signals.derived.Side
import badlog.signals.derived.frozenWhileTurning
import badlog.signals.derived.fullCurrentOf
import badlog.signals.derived.heldAt
import badlog.signals.derived.scaled
import badlog.signals.derived.sideFriction
import badlog.signals.derived.timesOf
import kotlin.math.abs

/** Returns the signals that are calculated from the two sides of a tank drive. */
internal fun sideSignals(robot: RobotParts): List<DerivedSignal> {
    val drive = robot.sides
    fun of(side: String, vararg quantities: Quantity) = quantities.firstNotNullOfOrNull { quantity ->
        drive.find { side in it.part && it.quantity == quantity }
    }
    val frozen = listOf("left" to "right", "right" to "left").mapNotNull { (side, other) ->
        val own = of(side, Quantity.POSITION)
        val turned = of(other, Quantity.POSITION)
        val output = of(side, Quantity.OUTPUT, Quantity.VOLTAGE)
        if (own == null || turned == null || output == null || of(side, Quantity.CURRENT) != null) null else sideFrozen(own, turned, output)
    }
    return frozen + frictions(drive)
}

/**
 * Whether a side stands still though it is driven and the other side moves. It is for logs without a current, which would distinguish a broken
 * encoder from a blocked side.
 */
private fun sideFrozen(own: PartTopic, other: PartTopic, output: PartTopic): DerivedSignal {
    val topics = listOf(own, output, other).map { it.signal.name }
    return DerivedSignal("side frozen", "", own.label, topics) { samples ->
        val (moved, driven, turned) = topics.map(samples::raw)
        val frozen = frozenWhileTurning(moved.x, turned.heldAt(moved.x), moved.y, samples.enabledAt(moved.x))
        val outputs = driven.heldAt(moved.x)
        val least = DRIVEN * if (output.quantity == Quantity.VOLTAGE) 12.0 else fullOf(driven)
        Series(moved.x, DoubleArray(moved.size) { if (abs(outputs[it]) > least) frozen.y[it] else 0.0 })
    }
}

private const val DRIVEN = 0.15

private fun frictions(drive: List<PartTopic>): List<DerivedSignal> {
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
                Quantity.CURRENT -> fullCurrentOf(listOf(all[0].y, all[2].y))
                Quantity.VOLTAGE -> 12.0
                else -> fullOf(all[0])
            }
            fun side(output: Int) = Side(scaled(all[output].heldAt(times), 1 / full), all[output + 1].heldAt(times))
            once(times, sideFriction(times, side(0), side(2)))
        }
    }
}
