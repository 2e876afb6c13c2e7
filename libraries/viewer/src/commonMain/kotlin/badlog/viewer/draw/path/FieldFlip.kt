package badlog.viewer.draw.path

import badlog.core.analysis.LogView
import badlog.signals.match.MatchOfLog
import badlog.signals.match.allianceIn
import badlog.signals.pose.Trail
import badlog.viewer.choices.board.FieldOrigin
import kotlin.math.PI

/**
 * Returns the flip that maps the poses of [view] from this origin onto [field] with blue origin. Null if they already have a blue origin.
 */
internal fun FieldOrigin.flipIn(view: LogView, field: Field = Field.PLAIN): FieldFlip? {
    if (this == FieldOrigin.CENTER) return FieldFlip(isMirrored = false, field, isFromCenter = true)
    val values = view.recording.values
    val isRed = this == FieldOrigin.RED || (this == FieldOrigin.AUTO && allianceIn(values) == MatchOfLog.RED)
    if (!isRed) return null
    val year = values.firstOrNull { it.name == "Start Time" }?.text?.take(YEAR_DIGITS)?.toIntOrNull()
    return FieldFlip(isMirrored = year in MIRRORED_YEARS, field)
}

/**
 * The flip that swaps the alliances' halves of the field, which are symmetric: mirrored, or rotated around the center. Applied twice, it
 * changes nothing.
 *
 * @param isFromCenter whether (0, 0) is the center of the field for the poses that it maps.
 */
internal class FieldFlip(private val isMirrored: Boolean, private val field: Field = Field.PLAIN, isFromCenter: Boolean = false) {
    private val share = if (isFromCenter) 0.5 else 1.0

    fun x(x: Double): Double = field.length * share - x

    fun y(y: Double): Double = if (isMirrored) y else field.width * share - y

    /** Returns the flipped [heading], in radians. */
    fun heading(heading: Double): Double {
        val turned = if (isMirrored) PI - heading else heading + PI
        return if (turned > PI) turned - 2 * PI else turned
    }

    fun trail(trail: Trail): Trail =
        Trail(trail.times, DoubleArray(trail.size) { x(trail.x[it]) }, DoubleArray(trail.size) { y(trail.y[it]) })
}

/** The years of fields with mirror symmetry; all others since 2020 have rotational symmetry. */
private val MIRRORED_YEARS = 2023..2024
private const val YEAR_DIGITS = 4
