package badlog.viewer.draw.color

import badlog.core.recording.Severity
import badlog.viewer.draw.mark.RobotMode
import kotlin.math.roundToInt

/** A color of page and window by its purpose, in the light and the dark theme, as `0xRRGGBB`. */
enum class Shade(private val light: Int, private val dark: Int) {
    /** The background of everything. */
    PAGE(0xF4F5F7, 0x12161C),

    /** The background of panels and graphs. */
    SURFACE(0xFFFFFF, 0x1A2028),

    /** The background of elements that stand out from a surface: headings, input fields. */
    RAISED(0xF0F2F5, 0x232B35),

    /** The lines between parts. */
    BORDER(0xDFE3E8, 0x303A46),

    /** Text. */
    TEXT(0x1B2330, 0xE6EAF0),

    /** Secondary text. */
    MUTED(0x596477, 0x9EABBB),

    /** Controls, and selected elements. */
    ACCENT(0x0B62C4, 0x6CB0FF),

    /** The background of a selection. */
    ACCENT_SOFT(0xE3EEFB, 0x1D3350),

    /** The grid lines of graphs. */
    GRID(0xE9ECF0, 0x28313C),

    /** The cursor. */
    CURSOR(0x1B2330, 0xE6EAF0),

    /** The marks of events. */
    EVENT(0xA84300, 0xFFA25E),

    /** Errors: lost data, or a failure. */
    ERROR(0xB3261E, 0xFF8F85),

    /** The background of an error. */
    ERROR_SOFT(0xFDECEA, 0x3B1F1F),

    /** Warnings: something doubtful. */
    WARNING(0x8A5300, 0xF3BD62),

    /** The background of a warning. */
    WARNING_SOFT(0xFFF3DC, 0x362A14),

    /** The background of a note. */
    NOTE_SOFT(0xEAF1F8, 0x1D2936),

    /** The shading of graphs while the robot is autonomous. */
    AUTONOMOUS(0xE08E00, 0xE8C04A),

    /** The shading of graphs while a driver controls the robot. */
    TELEOP(0x0B62C4, 0x5AA9FF),

    /** The shading of graphs while the robot is tested. */
    TEST(0x7B3FA0, 0xC79BFF),

    /** A lane that is off. */
    STATE_OFF(0xE4E8ED, 0x2A333E),

    /** Text on a lane. */
    STATE_TEXT(0x1B2330, 0xF2F5F9),
    ;

    /** Returns the color in the dark or the light theme. */
    fun of(isDark: Boolean): Int = if (isDark) dark else light
}

/** The number of line colors; further lines start over. */
const val LINE_COLORS: Int = 16

/** Returns the color of line [index], from 0, as `0xRRGGBB`. */
fun lineColor(index: Int, isDark: Boolean): Int = (if (isDark) DARK_LINES else LIGHT_LINES)[index.mod(LINE_COLORS)]

/** Returns the opacity of a line's color in a lane, so that text on top of it is readable. */
fun stateOpacity(isDark: Boolean): Double = if (isDark) 0.45 else 0.35

/** Returns [color], which is `0xRRGGBB`, in the notation of style sheets, with [opacity] from 0 to 1. */
fun cssColor(color: Int, opacity: Double = 1.0): String {
    val solid = "#" + color.toString(16).padStart(6, '0')
    return if (opacity == 1.0) solid else solid + (opacity * 255).toInt().toString(16).padStart(2, '0')
}

private val LIGHT_LINES = intArrayOf(
    0x0B62C4, 0xD4501A, 0x0A8062, 0x9B3FA0, 0xB07A00, 0x1591B5, 0xC2255C, 0x5B6B14,
    0x5F46C9, 0x8A4B20, 0x39424F, 0x13AA8B, 0xE36AA5, 0x123F8C, 0xE08E00, 0x7C8797,
)

private val DARK_LINES = intArrayOf(
    0x5AA9FF, 0xFF8A57, 0x3FCFA4, 0xD58BE0, 0xE8C04A, 0x5FD3EE, 0xFF7AA2, 0xB3CC4F,
    0xA99BFF, 0xD19A6F, 0xCDD6E1, 0x1FA88C, 0xF7B1D4, 0x3F78D8, 0xC97B16, 0x8794A5,
)

/** The colors of the dark or the light theme for a pen, as `0xAARRGGBB`. */
class PenColors private constructor(val isDark: Boolean) {
    /** Returns the color of [shade]. */
    operator fun get(shade: Shade): Int = OPAQUE or shade.of(isDark)

    /** Returns the color of line [index], from 0. */
    fun line(index: Int): Int = OPAQUE or lineColor(index, isDark)

    /** Returns the color of a block in state [index], from 0. It is a line's color, muted enough for text on top of it. */
    fun state(index: Int): Int = over(line(index), this[Shade.SURFACE], stateOpacity(isDark))

    /** Returns the color of [severity]. */
    fun severity(severity: Severity): Int = this[severityShade(severity)]

    companion object {
        private const val OPAQUE = 0xFF shl 24

        /** The light theme, which is also used on paper. */
        val LIGHT: PenColors = PenColors(isDark = false)

        val DARK: PenColors = PenColors(isDark = true)

        /** Returns the colors of the dark or the light theme. */
        fun of(isDark: Boolean): PenColors = if (isDark) DARK else LIGHT
    }
}

/** Returns the color of findings of [severity]. */
fun severityShade(severity: Severity): Shade = when (severity) {
    Severity.ERROR -> Shade.ERROR
    Severity.WARNING -> Shade.WARNING
    Severity.NOTE -> Shade.MUTED
}

/** Returns [color] with [opacity] from 0 to 1. */
fun faded(color: Int, opacity: Double): Int = (color and 0xFFFFFF) or ((opacity * 255).roundToInt() shl 24)

/** Returns the color that [color] with [opacity] has on [ground]. */
private fun over(color: Int, ground: Int, opacity: Double): Int {
    fun mixed(shift: Int): Int {
        val top = (color shr shift) and 0xFF
        val below = (ground shr shift) and 0xFF
        return (below + (top - below) * opacity).roundToInt() shl shift
    }
    return (0xFF shl 24) or mixed(16) or mixed(8) or mixed(0)
}

/**
 * Returns the shade of [mode]. It is amber for autonomous and blue for teleop, which everybody can distinguish, and gray if the log does
 * not name the mode.
 */
fun modeShade(mode: RobotMode): Shade = when (mode) {
    RobotMode.AUTONOMOUS -> Shade.AUTONOMOUS
    RobotMode.TELEOP -> Shade.TELEOP
    RobotMode.TEST, RobotMode.UTILITY -> Shade.TEST
    RobotMode.ENABLED -> Shade.MUTED
}

/** Returns the opacity of the shade behind a graph. It is visible at a glance, but weaker than the lines on top of it. */
fun modeOpacity(isDark: Boolean): Double = if (isDark) 0.11 else 0.08
