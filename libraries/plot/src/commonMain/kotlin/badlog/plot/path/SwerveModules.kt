package badlog.plot.path

import badlog.analysis.GraphSeries
import badlog.plot.cursor.indexAt
import badlog.recording.Topic
import badlog.rules.signal.TARGET_WORDS
import badlog.rules.signal.wordsOf
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/**
 * The four modules of a swerve drive, by the names of the topics that tell how fast and where to each wheel drives.
 *
 * @property isTarget whether that was wanted; else it was measured.
 */
public class SwerveModules internal constructor(
    internal val speeds: List<String>,
    internal val angles: List<String>,
    public val isTarget: Boolean,
    internal val meters: Double = 1.0,
    internal val radians: Double = 1.0,
)

/**
 * The modules that [topics] tell, front before back, left before right: arrays of the structs `SwerveModuleState` and
 * `SwerveModuleVelocity`; where there are none, topics of their own for each module, as [separateModulesOf] finds them.
 */
public fun swerveModulesOf(topics: List<Topic>): List<SwerveModules> = modulesInArrays(topics).ifEmpty { separateModulesOf(topics) }

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
 * Where to and how fast a wheel drives at a moment.
 *
 * @property places an arrow from the wheel on, as long as the way of a quarter of a second: x and y in turn.
 */
public class ModuleArrow internal constructor(public val places: DoubleArray, public val isTarget: Boolean) {
    internal fun flipped(flip: FieldFlip): ModuleArrow =
        ModuleArrow(DoubleArray(places.size) { if (it % 2 == 0) flip.x(places[it]) else flip.y(places[it]) }, isTarget)
}

/** The lines of [SwerveModules]. */
internal class ModuleLines private constructor(
    private val speeds: List<GraphSeries>,
    private val angles: List<GraphSeries>,
    private val modules: SwerveModules,
) {
    /** The arrows at [time] of a robot at ([x], [y]) that heads to [heading]. */
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

        /** How far a module is from the robot's middle, along and across, in meters. */
        private const val CORNER = 0.3
        private const val SECONDS = 0.25
        private const val BARB = 0.3
        private const val SPREAD = 0.5

        /** A shorter arrow, in meters, is none. */
        private const val STANDING = 0.005
    }
}

private val SPEEDS = listOf("/speed", "/velocity")
internal const val CORNERS = 4
