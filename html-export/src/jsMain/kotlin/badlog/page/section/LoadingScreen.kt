package badlog.page.section

import badlog.page.dom.add
import badlog.page.dom.element
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/** What stands on the page before the recording does. */
internal class LoadingScreen(name: String) {
    private lateinit var bar: HTMLElement

    val element: HTMLElement = element("div", "screen loading") {
        setAttribute("role", "status")
        add("p", "screen-title", "Reading $name…")
        add("div", "progress") { bar = add("div", "progress-bar") }
    }

    init {
        // Most files are read before anyone could read this.
        window.setTimeout({ element.classList.add("is-slow") }, PATIENCE_MILLISECONDS)
    }

    /** Shows that [share] of the work is done. */
    fun show(share: Double) {
        bar.style.width = "${share * 100}%"
    }

    private companion object {
        const val PATIENCE_MILLISECONDS = 300
    }
}
