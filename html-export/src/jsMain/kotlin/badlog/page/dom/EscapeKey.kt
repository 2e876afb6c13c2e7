package badlog.page.dom

import kotlinx.browser.document
import org.w3c.dom.events.Event
import org.w3c.dom.events.KeyboardEvent

/** Gives the Escape key to one thing alone while it goes on: [cancel] ends that. */
internal class EscapeKey(private val cancel: () -> Unit) {
    private val listener: (Event) -> Unit = { event ->
        if (event.unsafeCast<KeyboardEvent>().key == "Escape") {
            event.stopImmediatePropagation()
            cancel()
        }
    }

    /** Takes the key. */
    fun take() = document.addEventListener("keydown", listener, true)

    /** Gives it back. */
    fun giveBack() = document.removeEventListener("keydown", listener, true)
}
