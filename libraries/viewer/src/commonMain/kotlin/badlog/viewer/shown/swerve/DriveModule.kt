package badlog.viewer.shown.swerve

import badlog.core.analysis.GraphSeries
import badlog.viewer.shown.cursor.indexAt
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.roundToInt
import kotlin.math.sin

/**
 * One module of a [SwerveDrive].
 *
 * @property label the displayed name, as in findings: `Front Left`, `Module 2`.
 * @property sign a short name in a drawing: `FL`, `2`.
 */
class DriveModule internal constructor(
    val label: String,
    internal val place: ModulePlace,
    internal val actual: WheelLines,
    internal val target: WheelLines?,
) {
    val sign: String = if (label.last().isDigit()) label.takeLastWhile { it.isDigit() } else label.filter { it.isUpperCase() }

    /** Returns the measured velocity of the wheel at [time]; null if unknown. */
    fun actualAt(time: Double): WheelVector? = actual.vectorAt(time)

    /** Returns the target velocity of the wheel at [time]; null if unknown. */
    fun targetAt(time: Double): WheelVector? = target?.vectorAt(time)
}

/**
 * The velocity of a wheel over the ground, relative to the robot, in m/s. A wheel that points back and runs backward moves ahead.
 *
 * @property ahead the component toward the robot's front.
 * @property left the component toward its left.
 */
class WheelVector internal constructor(val ahead: Double, val left: Double)

/** The lines of a wheel. Its speed times [meters] is in m/s, its angle times [radians] in rad, counterclockwise from straight ahead. */
internal class WheelLines(val speed: GraphSeries, val angle: GraphSeries, private val meters: Double, private val radians: Double) {
    /** Whether the samples are in the order of x. */
    val isOrdered: Boolean get() = speed.data.isOrdered && angle.data.isOrdered

    /** The highest speed in m/s, except for the few highest samples, which may be wrong. 0 if the wheel never turned. */
    val fastest: Double by lazy {
        val turning = speed.data.y.filter { it.isFinite() && it != 0.0 }.map { abs(it) }.sorted()
        if (turning.isEmpty()) 0.0 else turning[(turning.lastIndex * HIGH).roundToInt()] * abs(meters)
    }

    fun vectorAt(time: Double): WheelVector? {
        val speed = speedOf(speed.indexAt(time))
        val angle = angleOf(angle.indexAt(time))
        return if (speed.isFinite() && angle.isFinite()) WheelVector(speed * cos(angle), speed * sin(angle)) else null
    }

    fun speedOf(sample: Int): Double = if (sample < 0) Double.NaN else speed.data.y[sample] * meters

    fun angleOf(sample: Int): Double = if (sample < 0) Double.NaN else angle.data.y[sample] * radians

    private companion object {
        /** The share of samples that are not higher than [fastest]. */
        const val HIGH = 0.995
    }
}
