package badlog.page.header

import badlog.page.dom.Icon
import badlog.page.dom.LocalStorage
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.view.Palette
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/** The choice of light colors, dark colors or the system's theme, which the browser remembers. [onChange] is called after each change. */
internal class ThemeSwitch(private val onChange: () -> Unit) {
    private enum class Theme(val icon: Icon, val text: String) {
        AUTO(Icon.AUTO, "Colors: follow the system"),
        LIGHT(Icon.SUN, "Colors: light"),
        DARK(Icon.MOON, "Colors: dark"),
    }

    /** The current colors. */
    val palette: Palette = Palette()

    private var theme = Theme.entries.firstOrNull { it.name == LocalStorage["theme"] } ?: Theme.AUTO
    private val systemIsDark = window.matchMedia("(prefers-color-scheme: dark)")
    private lateinit var button: HTMLElement

    val element: HTMLElement = element("div", "theme") {
        button = addIconButton("", theme.icon, theme.text) { choose(Theme.entries[(theme.ordinal + 1) % 3]) }
        button.id = "theme"
    }

    init {
        apply()
        systemIsDark.asDynamic().addEventListener("change") {
            apply()
            onChange()
        }
    }

    private fun choose(chosen: Theme) {
        theme = chosen
        LocalStorage["theme"] = theme.name
        button.textContent = ""
        button.appendChild(theme.icon.draw())
        button.title = theme.text
        button.setAttribute("aria-label", theme.text)
        apply()
        onChange()
    }

    private fun apply() {
        palette.isDark = theme == Theme.DARK || (theme == Theme.AUTO && systemIsDark.matches)
        palette.apply()
    }
}
