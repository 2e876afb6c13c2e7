package badlog.page.screen

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/** The screen shown while the log [name] is being read; [cancel] stops reading, if that is possible. */
internal class LoadingScreen(name: String, cancel: (() -> Unit)? = null) {
    private lateinit var bar: HTMLElement

    val element: HTMLElement = element("div", "screen loading") {
        setAttribute("role", "status")
        add("p", "screen-title", "Reading $name…")
        add("div", "progress") { bar = add("div", "progress-bar") }
        cancel?.let { addButton("", "Cancel", onClick = it).id = "cancel" }
    }

    init {
        // Most logs are loaded before anyone could read this.
        window.setTimeout({ element.classList.add("is-slow") }, PATIENCE_MILLISECONDS)
    }

    /** Shows the [share] of the work that is done, 0 to 1. */
    fun show(share: Double) {
        bar.style.width = "${share * 100}%"
    }

    private companion object {
        const val PATIENCE_MILLISECONDS = 300
    }
}

/** Returns the screen shown instead of a log that cannot be shown. */
internal fun failureScreen(title: String, explanation: String, tools: HTMLElement? = null): HTMLElement = element("div", "screen failure") {
    setAttribute("role", "alert")
    add("p", "screen-title", title)
    add("p", "screen-text", explanation)
    if (tools != null) appendChild(tools)
}
