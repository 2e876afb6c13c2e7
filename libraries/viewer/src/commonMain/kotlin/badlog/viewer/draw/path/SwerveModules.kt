package badlog.viewer.draw.path

import badlog.core.analysis.GraphSeries
import badlog.core.recording.Topic
import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf
import badlog.viewer.shown.cursor.indexAt
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/**
 * The four modules of a swerve drive, by the names of the topics with the speed and direction of each wheel.
 *
 * @property isTarget whether these are targets rather than measured values.
 */
class SwerveModules internal constructor(
    internal val speeds: List<String>,
    internal val angles: List<String>,
    val isTarget: Boolean,
    internal val meters: Double = 1.0,
    internal val radians: Double = 1.0,
)

/**
 * Returns the modules in [topics], front before back, left before right: arrays of the structs `SwerveModuleState` and
 * `SwerveModuleVelocity`; if there are none, separate topics for each module, see [separateModulesOf].
 */
fun swerveModulesOf(topics: List<Topic>): List<SwerveModules> = modulesInArrays(topics).ifEmpty { separateModulesOf(topics) }

private fun modulesInArrays(topics: List<Topic>): List<SwerveModules> {
    val names = topics.filter { it.samples.isNotEmpty() && "SwerveModule" in it.type }.mapTo(LinkedHashSet()) { it.name }
    return names.mapNotNull { name ->
        val field = SPEEDS.firstOrNull { name.endsWith("[0]$it") } ?: return@mapNotNull null
        val base = name.removeSuffix("[0]$field")
        val modules = SwerveModules(
            List(CORNERS) { "$base[$it]$field" },
            List(CORNERS) { "$base[$it]/angle/value" },
            isTarget = wordsOf(base).any { it in TARGET_WORDS },
        )
        modules.takeIf { names.containsAll(it.speeds + it.angles) }
    }
}

/**
 * The direction and speed of a wheel at a moment.
 *
 * @property places an arrow from the wheel, as long as its travel in a quarter of a second: alternating x and y.
 */
class ModuleArrow internal constructor(val places: DoubleArray, val isTarget: Boolean) {
    internal fun flipped(flip: FieldFlip): ModuleArrow =
        ModuleArrow(DoubleArray(places.size) { if (it % 2 == 0) flip.x(places[it]) else flip.y(places[it]) }, isTarget)
}

/** The lines of [SwerveModules]. */
internal class ModuleLines private constructor(
    private val speeds: List<GraphSeries>,
    private val angles: List<GraphSeries>,
    private val modules: SwerveModules,
) {
    /** Returns the arrows at [time] of a robot at ([x], [y]) with [heading]. */
    fun arrowsAt(time: Double, x: Double, y: Double, heading: Double): List<ModuleArrow> = speeds.indices.mapNotNull { i ->
        val length = valueAt(speeds[i], time) * modules.meters * SECONDS
        val turn = heading + valueAt(angles[i], time) * modules.radians
        val ahead = if (i < CORNERS / 2) CORNER else -CORNER
        val left = if (i % 2 == 0) CORNER else -CORNER
        val fromX = x + ahead * cos(heading) - left * sin(heading)
        val fromY = y + ahead * sin(heading) + left * cos(heading)
        val toX = fromX + length * cos(turn)
        val toY = fromY + length * sin(turn)
        fun barbX(side: Double) = toX - length * BARB * cos(turn + side)
        fun barbY(side: Double) = toY - length * BARB * sin(turn + side)
        val places = doubleArrayOf(fromX, fromY, toX, toY, barbX(SPREAD), barbY(SPREAD), toX, toY, barbX(-SPREAD), barbY(-SPREAD))
        if (abs(length) < STANDING || toX.isNaN()) null else ModuleArrow(places, modules.isTarget)
    }

    private fun valueAt(line: GraphSeries, time: Double) = line.indexAt(time).let { if (it < 0) Double.NaN else line.data.y[it] }

    companion object {
        fun of(modules: SwerveModules, line: (String) -> GraphSeries?): ModuleLines? {
            val speeds = modules.speeds.mapNotNull(line)
            val angles = modules.angles.mapNotNull(line)
            return if (speeds.size == CORNERS && angles.size == CORNERS) ModuleLines(speeds, angles, modules) else null
        }

        /** The distance of a module from the robot's center, lengthwise and crosswise, in meters. */
        private const val CORNER = 0.3
        private const val SECONDS = 0.25
        private const val BARB = 0.3
        private const val SPREAD = 0.5

        /** Arrows shorter than this, in meters, are not drawn. */
        private const val STANDING = 0.005
    }
}

private val SPEEDS = listOf("/speed", "/velocity")
internal const val CORNERS = 4
