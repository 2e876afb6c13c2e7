package badlog.viewer.shown.swerve

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.knowsEnabled
import badlog.signals.swerve.DriveTopics
import badlog.signals.swerve.SwerveModules
import badlog.viewer.shown.cursor.indexAt
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.roundToInt
import kotlin.math.sin

/**
 * The swerve drive of a log.
 *
 * @property modules the three to six modules, in the order of the log, or front before back, left before right.
 */
class SwerveDrive private constructor(private val view: LogView, val modules: List<DriveModule>, private val withoutTarget: List<String>) {
    private val isOrdered get() = modules.all { module -> listOfNotNull(module.actual, module.target).all { it.isOrdered } }

    /** The displayed reason why there are no [errors], as a sentence; null if there are any. */
    val errorsLack: String? by lazy {
        when {
            withoutTarget.size == modules.size -> "This log has no targets of its modules, so their errors are not known."
            withoutTarget.isNotEmpty() -> "This log has no target of ${withoutTarget.joinToString(" and ")}, so the errors are not known."
            !isOrdered -> "${view.xAxis.title} goes backwards in this log, so the errors are not known."
            else -> null
        }
    }

    /** The highest speed of a wheel, actual or target, in m/s, except for the few highest samples. 0 if no wheel turned. */
    val fastest: Double by lazy { modules.maxOf { maxOf(it.actual.fastest, it.target?.fastest ?: 0.0) } }

    /** The errors of the modules relative to their targets; null if unknown, see [errorsLack]. The first use reads all samples. */
    val errors: DriveErrors? by lazy {
        val enabled = if (view.knowsEnabled) view.enabledSpans().map { it.span } else null
        val second = 1 / (Units.secondsIn(view.xAxis.unit) ?: 1.0)
        if (errorsLack == null) DriveErrors.of(modules, enabled, view.xAxis.range?.endInclusive ?: Double.NaN, second) else null
    }

    companion object {
        /** The sentence for a log without modules. */
        const val NONE: String =
            "This log has no swerve modules that badlog recognizes; log SwerveModuleState, or speed and angle of each module."

        /** The displayed meaning of the arrows. */
        const val ARROWS: String = "Solid: actual. Outline: target."

        /**
         * Returns the drive of [view]; null if there is none. It has the first measured modules, with targets if all of them have one;
         * optimized targets are preferred. Only names are examined.
         */
        fun of(view: LogView): SwerveDrive? {
            val topics = view.recording.topics.associateBy { it.name }
            fun line(name: String): GraphSeries = view.seriesOf(topics.getValue(name))
            fun wheels(modules: SwerveModules) = modules.speeds.zip(modules.angles) { speed, angle ->
                WheelLines(line(speed), line(angle), modules.meters, modules.radians)
            }
            val drive = DriveTopics.of(view.recording.topics) ?: return null
            val wanted = drive.target?.let { it.labels.zip(wheels(it)).toMap() }.orEmpty()
            val places = drive.measured.places
            val modules = wheels(drive.measured).mapIndexed { i, wheel ->
                val label = drive.measured.labels[i]
                DriveModule(label, places[i], wheel, wanted[label])
            }
            return SwerveDrive(view, modules, drive.withoutTarget)
        }
    }
}

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
}

/**
 * The place of a module on its robot, as multiples of half the robot's length and width.
 *
 * @property ahead the distance in front of the center; negative behind it.
 * @property left the distance to the left of the center; negative to the right.
 */
internal class ModulePlace(val ahead: Double, val left: Double)

/** The places of these modules, in their order. */
internal val SwerveModules.places: List<ModulePlace> get() = corners?.map(CORNER_PLACES::get) ?: modulePlacesOf(labels.size)

/**
 * Returns the assumed places of [count] modules, in their order, because logs do not contain them. Four modules are at the corners, front
 * before back, left before right. Three form a triangle with two in front; more are around a circle, clockwise from the front left.
 */
internal fun modulePlacesOf(count: Int): List<ModulePlace> = when (count) {
    TRIANGLE.size -> TRIANGLE

    CORNER_PLACES.size -> CORNER_PLACES

    else -> {
        val turns = List(count) { PI / 4 - 2 * PI * it / count }
        // The outermost modules are on the robot's edge, as the corners are: beyond it, their arrows would leave the picture.
        val outermost = turns.maxOf { maxOf(abs(cos(it)), abs(sin(it))) }
        turns.map { ModulePlace(cos(it) / outermost, sin(it) / outermost) }
    }
}

private val TRIANGLE = listOf(ModulePlace(1.0, 1.0), ModulePlace(1.0, -1.0), ModulePlace(-1.0, 0.0))

/** The corners, front before back, left before right. */
private val CORNER_PLACES: List<ModulePlace> =
    listOf(ModulePlace(1.0, 1.0), ModulePlace(1.0, -1.0), ModulePlace(-1.0, 1.0), ModulePlace(-1.0, -1.0))

/** The share of samples that are not higher than [fastest]. */
private const val HIGH = 0.995
