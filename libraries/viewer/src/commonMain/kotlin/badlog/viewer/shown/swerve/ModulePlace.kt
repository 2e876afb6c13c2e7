package badlog.viewer.shown.swerve

import badlog.signals.swerve.SwerveModules
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

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
