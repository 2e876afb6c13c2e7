package badlog.page.view

import badlog.plot.color.LINE_COLORS
import badlog.plot.color.Shade
import badlog.plot.color.cssColor
import badlog.plot.color.lineColor
import badlog.plot.color.stateOpacity
import badlog.recording.Severity
import kotlinx.browser.document
import org.w3c.dom.HTMLElement

/** The colors of the theme of now, as canvases and the style sheet write them. */
internal class Palette(var isDark: Boolean = false) {
    /** The color of line [index], from 0. */
    fun line(index: Int): String = cssColor(lineColor(index, isDark))

    /** The color of a block in state [index], from 0: a line's color, quiet enough for text upon it. */
    fun state(index: Int): String = cssColor(lineColor(index, isDark), stateOpacity(isDark))

    /** The color of what is of [severity]. */
    fun severity(severity: Severity): String = this[SEVERITIES[severity.ordinal]]

    operator fun get(shade: Shade): String = cssColor(shade.of(isDark))

    /** Gives the colors to the style sheet. */
    fun apply() {
        val root = document.documentElement.unsafeCast<HTMLElement>()
        root.setAttribute("data-theme", if (isDark) "dark" else "light")
        for (shade in Shade.entries) root.style.setProperty("--" + shade.name.lowercase().replace('_', '-'), this[shade])
        for (index in 0 until LINE_COLORS) root.style.setProperty("--line-$index", line(index))
        root.style.setProperty("--accent-veil", cssColor(Shade.ACCENT.of(isDark), VEIL))
    }

    private companion object {
        val SEVERITIES = listOf(Shade.MUTED, Shade.WARNING, Shade.ERROR)

        /** How much of the accent lies over what is selected. */
        const val VEIL = 0.18
    }
}
