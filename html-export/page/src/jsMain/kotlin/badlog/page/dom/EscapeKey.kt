package badlog.page.dom

import kotlinx.browser.document
import org.w3c.dom.events.Event
import org.w3c.dom.events.KeyboardEvent

/** Reserves the Escape key for one activity while it lasts: the key calls [cancel], which ends the activity. */
internal class EscapeKey(private val cancel: () -> Unit) {
    private val listener: (Event) -> Unit = { event ->
        if (event.unsafeCast<KeyboardEvent>().key == "Escape") {
            event.stopImmediatePropagation()
            cancel()
        }
    }

    /** Reserves the key. */
    fun take() = document.addEventListener("keydown", listener, true)

    /** Releases the key. */
    fun giveBack() = document.removeEventListener("keydown", listener, true)
}
