package badlog.page.dom

import org.w3c.dom.events.Event
import org.w3c.dom.events.EventTarget

/** What the shown log listens to outside its own elements. It ends when something else is shown. */
internal object PageEvents {
    private var lasting = newController()

    /** Calls [listener] at each event of [type] on [target], until [end]. */
    fun on(target: EventTarget, type: String, listener: (Event) -> Unit) =
        target.addEventListener(type, listener, json("signal" to lasting.signal))

    /** Ends all listening. */
    fun end() {
        lasting.abort()
        lasting = newController()
    }

    private fun newController(): dynamic = js("new AbortController()")
}
