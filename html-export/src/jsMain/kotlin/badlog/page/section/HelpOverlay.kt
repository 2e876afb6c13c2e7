package badlog.page.section

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import org.w3c.dom.HTMLElement

/** The keys and gestures, in a dialog. */
internal class HelpOverlay {
    val element: HTMLElement = element("dialog", "help") {
        id = "help"
        setAttribute("aria-label", "Keys and gestures")
        add("div", "help-head") {
            add("h2", "", "Keys and gestures")
            addIconButton("", Icon.CLOSE, "Close") { close() }
        }
        add("dl", "help-keys") {
            for ((keys, meaning) in KEYS) {
                add("dt") {
                    for (key in keys.split(' ')) if (key in JOINERS) add("span", "", " $key ") else add("kbd", "", key)
                }
                add("dd", "", meaning)
            }
        }
        // A click on the dialog itself is one beside its content.
        addEventListener("click", { if (it.target == this) close() })
    }

    /** Shows it, or takes it away. */
    fun toggle() {
        if (element.hasAttribute("open")) close() else element.asDynamic().showModal()
    }

    private fun close() {
        element.asDynamic().close()
    }

    private companion object {
        val JOINERS = setOf("or", "and", "to")
        val KEYS = listOf(
            "drag" to "zoom to what is dragged over",
            "Shift and drag" to "move along",
            "Ctrl and wheel" to "zoom around the pointer; a pinch does the same",
            "double-click" to "show everything",
            "← →" to "move the cursor by one sample; with Shift by ten",
            "+ −" to "zoom around the cursor",
            "0 or Home" to "show everything",
            "Backspace" to "back to the zoom before",
            "N and P" to "the next finding, and the one before",
            "F" to "add a formula",
            "/" to "search",
            "Escape" to "clear the search, take the cursor away, give up a drag",
            "?" to "this help",
            "touch" to "tap sets the cursor, sideways drag zooms or moves, double tap shows everything",
        )
    }
}
