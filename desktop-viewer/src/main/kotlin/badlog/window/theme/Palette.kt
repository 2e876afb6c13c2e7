package badlog.window.theme

import androidx.compose.runtime.Immutable
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.compositeOver
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.lineColor
import badlog.viewer.draw.color.modeShade
import badlog.viewer.draw.color.stateOpacity
import badlog.viewer.draw.mark.RobotMode

/** The colors of a theme, see [Shade]; the same as on an exported page. */
@Immutable
internal class Palette private constructor(val isDark: Boolean) {
    val page: Color = of(Shade.PAGE)
    val surface: Color = of(Shade.SURFACE)
    val raised: Color = of(Shade.RAISED)
    val border: Color = of(Shade.BORDER)
    val text: Color = of(Shade.TEXT)
    val muted: Color = of(Shade.MUTED)
    val accent: Color = of(Shade.ACCENT)
    val accentSoft: Color = of(Shade.ACCENT_SOFT)
    val cursor: Color = of(Shade.CURSOR)
    val event: Color = of(Shade.EVENT)
    val error: Color = of(Shade.ERROR)
    val errorSoft: Color = of(Shade.ERROR_SOFT)
    val warning: Color = of(Shade.WARNING)
    val warningSoft: Color = of(Shade.WARNING_SOFT)
    val stateText: Color = of(Shade.STATE_TEXT)

    /** The same colors for a pen. */
    val pen: PenColors = PenColors.of(isDark)
    private val lines = List(LINE_COLORS) { opaque(lineColor(it, isDark)) }

    /** Returns the color of line [index], from 0; the colors repeat. */
    fun line(index: Int): Color = lines[index.mod(LINE_COLORS)]

    /** Returns the color of a lane in state [index], from 0. It is a line's color, muted enough for text on top of it. */
    fun state(index: Int): Color = line(index).copy(alpha = stateOpacity(isDark).toFloat()).compositeOver(surface)

    /** Returns the color that shades the times of [mode]. */
    fun mode(mode: RobotMode): Color = of(modeShade(mode))

    private fun of(shade: Shade) = opaque(shade.of(isDark))

    private fun opaque(color: Int) = Color(color or OPAQUE)

    companion object {
        private const val OPAQUE = 0xFF shl 24

        /** The light theme. */
        val LIGHT = Palette(isDark = false)

        /** The dark theme. */
        val DARK = Palette(isDark = true)
    }
}

/** The colors of the current theme. */
internal val LocalPalette = staticCompositionLocalOf { Palette.LIGHT }
