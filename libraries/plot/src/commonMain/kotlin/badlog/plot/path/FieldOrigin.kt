package badlog.plot.path

import badlog.analysis.LogView
import badlog.analysis.meant
import badlog.rules.path.Trail
import kotlin.math.PI

/**
 * From which alliance's wall the poses of a log are measured: which corner of the field is (0, 0), the one at the right of that wall.
 *
 * @property label what a menu calls it.
 */
public enum class FieldOrigin(public val label: String) {
    /** From the blue one's, as WPILib has it. */
    BLUE("Blue origin"),

    /** From the red one's. */
    RED("Red origin"),

    /** From that of the robot's own alliance in each match; of the blue one where a log does not say. */
    AUTO("Auto origin"),
    ;

    internal val key: String get() = name.lowercase()

    /** What lays the poses of [view] onto [field] as the blue alliance sees it; null where they are so. */
    public fun flipIn(view: LogView, field: Field = Field.PLAIN): FieldFlip? {
        val values = view.recording.values
        val isRed = this == RED || (this == AUTO && values.meant(*ALLIANCES)?.startsWith("red", ignoreCase = true) == true)
        if (!isRed) return null
        val year = values.firstOrNull { it.name == "Start Time" }?.text?.take(YEAR_DIGITS)?.toIntOrNull()
        return FieldFlip(isMirrored = year in MIRRORED_YEARS, field)
    }

    internal companion object {
        fun of(key: String?): FieldOrigin? = entries.find { it.key == key }

        private val ALLIANCES = arrayOf("alliance", "alliance color", "alliance colour", "alliance station")

        /** The fields of these years are the same in a mirror; all others since 2020, when turned around. */
        private val MIRRORED_YEARS = 2023..2024
        private const val YEAR_DIGITS = 4
    }
}

/** Exchanges the alliances' halves of the field, which are alike: in a mirror, or turned around the middle. Twice, it changes nothing. */
public class FieldFlip internal constructor(private val isMirrored: Boolean, private val field: Field = Field.PLAIN) {
    internal fun x(x: Double): Double = field.length - x

    internal fun y(y: Double): Double = if (isMirrored) y else field.width - y

    /** That of a [heading] in radians. */
    internal fun heading(heading: Double): Double {
        val turned = if (isMirrored) PI - heading else heading + PI
        return if (turned > PI) turned - 2 * PI else turned
    }

    internal fun trail(trail: Trail): Trail =
        Trail(trail.times, DoubleArray(trail.size) { x(trail.x[it]) }, DoubleArray(trail.size) { y(trail.y[it]) })
}
