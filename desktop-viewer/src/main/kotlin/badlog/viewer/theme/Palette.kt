package badlog.viewer.theme

import androidx.compose.runtime.Immutable
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.graphics.Color

/**
 * The colours of a theme; the same as those of an exported page.
 *
 * @property page behind everything.
 * @property surface of panels and graphs.
 * @property raised of what stands out from a surface: headings, fields.
 * @property border between parts.
 * @property text of what is read.
 * @property muted of what is read second.
 * @property accent of what can be done, and what is chosen.
 * @property accentSoft behind what is chosen.
 * @property grid of the lines behind graphs.
 * @property cursor of the cursor.
 * @property event of events' marks.
 * @property error of what is lost or did not work.
 * @property errorSoft behind it.
 * @property warning of what is doubtful.
 * @property warningSoft behind it.
 * @property stateOff of a lane that is off.
 * @property lines of lines, in their order; further ones begin again.
 */
@Immutable
internal class Palette(
    val isDark: Boolean,
    val page: Color,
    val surface: Color,
    val raised: Color,
    val border: Color,
    val text: Color,
    val muted: Color,
    val accent: Color,
    val accentSoft: Color,
    val grid: Color,
    val cursor: Color,
    val event: Color,
    val error: Color,
    val errorSoft: Color,
    val warning: Color,
    val warningSoft: Color,
    val stateOff: Color,
    val lines: List<Color>,
) {
    /** The colour of line [index], from 0. */
    fun line(index: Int): Color = lines[index.mod(lines.size)]

    companion object {
        /** For bright rooms. */
        val LIGHT = Palette(
            isDark = false,
            page = Color(0xFFF4F5F7),
            surface = Color(0xFFFFFFFF),
            raised = Color(0xFFF0F2F5),
            border = Color(0xFFDFE3E8),
            text = Color(0xFF1B2330),
            muted = Color(0xFF596477),
            accent = Color(0xFF0B62C4),
            accentSoft = Color(0xFFE3EEFB),
            grid = Color(0xFFE9ECF0),
            cursor = Color(0xFF1B2330),
            event = Color(0xFFA84300),
            error = Color(0xFFB3261E),
            errorSoft = Color(0xFFFDECEA),
            warning = Color(0xFF8A5300),
            warningSoft = Color(0xFFFFF3DC),
            stateOff = Color(0xFFE4E8ED),
            lines = listOf(
                0xFF0B62C4, 0xFFD4501A, 0xFF0A8062, 0xFF9B3FA0, 0xFFB07A00, 0xFF1591B5, 0xFFC2255C, 0xFF5B6B14,
                0xFF5F46C9, 0xFF8A4B20, 0xFF39424F, 0xFF13AA8B, 0xFFE36AA5, 0xFF123F8C, 0xFFE08E00, 0xFF7C8797,
            ).map { Color(it) },
        )

        /** For dark rooms. */
        val DARK = Palette(
            isDark = true,
            page = Color(0xFF12161C),
            surface = Color(0xFF1A2028),
            raised = Color(0xFF232B35),
            border = Color(0xFF303A46),
            text = Color(0xFFE6EAF0),
            muted = Color(0xFF9EABBB),
            accent = Color(0xFF6CB0FF),
            accentSoft = Color(0xFF1D3350),
            grid = Color(0xFF28313C),
            cursor = Color(0xFFE6EAF0),
            event = Color(0xFFFFA25E),
            error = Color(0xFFFF8F85),
            errorSoft = Color(0xFF3B1F1F),
            warning = Color(0xFFF3BD62),
            warningSoft = Color(0xFF362A14),
            stateOff = Color(0xFF2A333E),
            lines = listOf(
                0xFF5AA9FF, 0xFFFF8A57, 0xFF3FCFA4, 0xFFD58BE0, 0xFFE8C04A, 0xFF5FD3EE, 0xFFFF7AA2, 0xFFB3CC4F,
                0xFFA99BFF, 0xFFD19A6F, 0xFFCDD6E1, 0xFF1FA88C, 0xFFF7B1D4, 0xFF3F78D8, 0xFFC97B16, 0xFF8794A5,
            ).map { Color(it) },
        )
    }
}

/** The colours of the theme of now. */
internal val LocalPalette = staticCompositionLocalOf { Palette.LIGHT }
