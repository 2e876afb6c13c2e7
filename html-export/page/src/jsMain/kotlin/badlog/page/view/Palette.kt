package badlog.page.view

import badlog.core.recording.Severity
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.cssColor
import badlog.viewer.draw.color.lineColor
import badlog.viewer.draw.color.stateOpacity
import kotlinx.browser.document
import org.w3c.dom.HTMLElement

/** The colors of the current theme, in the notation of canvases and the style sheet. */
internal class Palette(var isDark: Boolean = false) {
    /** Returns the color of line [index], from 0. */
    fun line(index: Int): String = cssColor(lineColor(index, isDark))

    /** Returns the color of a block in state [index], from 0: a line's color, muted enough for text on top of it. */
    fun state(index: Int): String = cssColor(lineColor(index, isDark), stateOpacity(isDark))

    /** Returns the color of [severity]. */
    fun severity(severity: Severity): String = this[SEVERITIES[severity.ordinal]]

    operator fun get(shade: Shade): String = cssColor(shade.of(isDark))

    /** Passes the colors to the style sheet. */
    fun apply() {
        val root = document.documentElement.unsafeCast<HTMLElement>()
        root.setAttribute("data-theme", if (isDark) "dark" else "light")
        for (shade in Shade.entries) root.style.setProperty("--" + shade.name.lowercase().replace('_', '-'), this[shade])
        for (index in 0 until LINE_COLORS) root.style.setProperty("--line-$index", line(index))
        root.style.setProperty("--accent-veil", cssColor(Shade.ACCENT.of(isDark), VEIL))
    }

    private companion object {
        val SEVERITIES = listOf(Shade.MUTED, Shade.WARNING, Shade.ERROR)

        /** The opacity of the accent color over a selection. */
        const val VEIL = 0.18
    }
}
