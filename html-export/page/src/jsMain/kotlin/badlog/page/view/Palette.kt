package badlog.page.view

import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.cssColor
import badlog.viewer.draw.color.lineColor
import kotlinx.browser.document
import org.w3c.dom.HTMLElement

/** The colors of the current theme. */
internal class Palette(var isDark: Boolean = false) {
    /** The current colors for a pen. */
    val colors: PenColors get() = PenColors.of(isDark)

    /** Passes the colors to the style sheet. */
    fun apply() {
        val root = document.documentElement.unsafeCast<HTMLElement>()
        root.setAttribute("data-theme", if (isDark) "dark" else "light")
        for (shade in Shade.entries) root.style.setProperty("--" + shade.name.lowercase().replace('_', '-'), cssColor(shade.of(isDark)))
        for (index in 0 until LINE_COLORS) root.style.setProperty("--line-$index", cssColor(lineColor(index, isDark)))
        root.style.setProperty("--accent-veil", cssColor(Shade.ACCENT.of(isDark), VEIL))
    }
}

/** The opacity of the accent color over a selection. */
private const val VEIL = 0.18
