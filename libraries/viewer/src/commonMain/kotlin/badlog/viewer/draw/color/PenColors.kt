package badlog.viewer.draw.color

import badlog.core.recording.Severity
import kotlin.math.roundToInt

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
