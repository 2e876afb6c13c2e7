package badlog.viewer.draw.path

import badlog.core.analysis.LogView
import badlog.signals.match.MatchOfLog
import badlog.signals.match.allianceIn
import badlog.signals.pose.Trail
import kotlin.math.PI

/**
 * The alliance wall from which the poses of a log are measured: the corner at its right end is (0, 0), unless the center of the field is.
 *
 * @property label its name in a menu.
 */
enum class FieldOrigin(val label: String) {
    /** The blue alliance's wall, as in WPILib. */
    BLUE("Blue origin"),

    /** The red alliance's wall. */
    RED("Red origin"),

    /** The wall of the robot's own alliance in each match; the blue one if the log does not have the alliance. */
    AUTO("Auto origin"),

    /** The center of the field as seen from the red alliance's wall: x points to the blue one. */
    CENTER("Center origin"),
    ;

    internal val key: String get() = name.lowercase()

    /** Returns the flip that maps the poses of [view] onto [field] with blue origin; null if they already have it. */
    fun flipIn(view: LogView, field: Field = Field.PLAIN): FieldFlip? {
        if (this == CENTER) return FieldFlip(isMirrored = false, field, isFromCenter = true)
        val values = view.recording.values
        val isRed = this == RED || (this == AUTO && allianceIn(values) == MatchOfLog.RED)
        if (!isRed) return null
        val year = values.firstOrNull { it.name == "Start Time" }?.text?.take(YEAR_DIGITS)?.toIntOrNull()
        return FieldFlip(isMirrored = year in MIRRORED_YEARS, field)
    }

    internal companion object {
        fun of(key: String?): FieldOrigin? = entries.find { it.key == key }

        /** The fields of these years have mirror symmetry; all others since 2020, rotational symmetry. */
        private val MIRRORED_YEARS = 2023..2024
        private const val YEAR_DIGITS = 4
    }
}

/**
 * Swaps the alliances' halves of the field, which are symmetric: mirrored, or rotated around the center. Applied twice, it changes nothing.
 *
 * @param isFromCenter whether (0, 0) is the center of the field for the poses that it gets.
 */
class FieldFlip internal constructor(
    private val isMirrored: Boolean,
    private val field: Field = Field.PLAIN,
    isFromCenter: Boolean = false,
) {
    private val share = if (isFromCenter) 0.5 else 1.0

    internal fun x(x: Double): Double = field.length * share - x

    internal fun y(y: Double): Double = if (isMirrored) y else field.width * share - y

    /** Returns the flipped [heading], in radians. */
    internal fun heading(heading: Double): Double {
        val turned = if (isMirrored) PI - heading else heading + PI
        return if (turned > PI) turned - 2 * PI else turned
    }

    internal fun trail(trail: Trail): Trail =
        Trail(trail.times, DoubleArray(trail.size) { x(trail.x[it]) }, DoubleArray(trail.size) { y(trail.y[it]) })
}
