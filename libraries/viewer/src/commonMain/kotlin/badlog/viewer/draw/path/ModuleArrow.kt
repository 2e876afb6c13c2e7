package badlog.viewer.draw.path

import badlog.core.analysis.GraphSeries
import badlog.signals.swerve.SwerveModules
import badlog.viewer.shown.cursor.indexAt
import badlog.viewer.shown.swerve.places
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/**
 * The direction and speed of a wheel at a moment.
 *
 * @property places the points of an arrow from the wheel, alternating x and y. It is as long as the wheel's travel in a quarter of a
 *   second.
 */
internal class ModuleArrow(val places: DoubleArray, val isTarget: Boolean) {
    fun flipped(flip: FieldFlip): ModuleArrow =
        ModuleArrow(DoubleArray(places.size) { if (it % 2 == 0) flip.x(places[it]) else flip.y(places[it]) }, isTarget)
}

/** The lines of [SwerveModules]. */
internal class ModuleLines private constructor(
    private val speeds: List<GraphSeries>,
    private val angles: List<GraphSeries>,
    private val modules: SwerveModules,
) {
    private val places = modules.places

    /** Returns the arrows at [time] for a robot at ([x], [y]) with [heading]. */
    fun arrowsAt(time: Double, x: Double, y: Double, heading: Double): List<ModuleArrow> = speeds.indices.mapNotNull { i ->
        val length = valueAt(speeds[i], time) * modules.meters * SECONDS
        val turn = heading + valueAt(angles[i], time) * modules.radians
        val ahead = places[i].ahead * CORNER
        val left = places[i].left * CORNER
        val fromX = x + ahead * cos(heading) - left * sin(heading)
        val fromY = y + ahead * sin(heading) + left * cos(heading)
        val toX = fromX + length * cos(turn)
        val toY = fromY + length * sin(turn)
        fun barbX(side: Double) = toX - length * BARB * cos(turn + side)
        fun barbY(side: Double) = toY - length * BARB * sin(turn + side)
        val arrow = doubleArrayOf(fromX, fromY, toX, toY, barbX(SPREAD), barbY(SPREAD), toX, toY, barbX(-SPREAD), barbY(-SPREAD))
        if (abs(length) < STANDING || toX.isNaN()) null else ModuleArrow(arrow, modules.isTarget)
    }

    private fun valueAt(line: GraphSeries, time: Double) = line.indexAt(time).let { if (it < 0) Double.NaN else line.data.y[it] }

    companion object {
        fun of(modules: SwerveModules, line: (String) -> GraphSeries?): ModuleLines? {
            val speeds = modules.speeds.mapNotNull(line)
            val angles = modules.angles.mapNotNull(line)
            val isWhole = speeds.size == modules.speeds.size && angles.size == modules.angles.size
            return if (isWhole) ModuleLines(speeds, angles, modules) else null
        }

        /** The distance of a module from the robot's center, lengthwise and crosswise, in meters. */
        private const val CORNER = 0.3
        private const val SECONDS = 0.25
        private const val BARB = 0.3
        private const val SPREAD = 0.5

        /** The minimum length of a drawn arrow, in meters. */
        private const val STANDING = 0.005
    }
}
