package badlog.page.dom

import org.w3c.dom.Element
import org.w3c.dom.events.Event
import org.w3c.dom.events.EventTarget

/** The shown log's listeners outside its own elements, and its work. Both end when something else is shown. */
internal object PageEvents {
    private var lasting = newController()
    private val ends = ArrayList<() -> Unit>()

    /** Calls [listener] at each event of [type] on [target], until [end]. */
    fun on(target: EventTarget, type: String, listener: (Event) -> Unit) =
        target.addEventListener(type, listener, json("signal" to lasting.signal))

    /** Calls [listener] at the next event of [type] on [target], unless [end] comes first. */
    fun once(target: EventTarget, type: String, listener: (Event) -> Unit) =
        target.addEventListener(type, listener, json("signal" to lasting.signal, "once" to true))

    /** Calls [work] once, at the next [end]. */
    fun onEnd(work: () -> Unit) {
        ends += work
    }

    /** Ends all listeners and all work. */
    fun end() {
        lasting.abort()
        lasting = newController()
        val works = ends.toList()
        ends.clear()
        for (work in works) work()
    }

    private fun newController(): dynamic = js("new AbortController()")
}

/** The browser's class that reports when elements come near the screen or leave it. */
internal external class IntersectionObserver(callback: (entries: Array<IntersectionObserverEntry>) -> Unit, options: dynamic) {
    fun observe(target: Element)
    fun unobserve(target: Element)
}

/** The report of an [IntersectionObserver] about one element. */
internal external interface IntersectionObserverEntry {
    val target: Element
    val isIntersecting: Boolean
}

/** The browser's class that reports when an element's size changes. */
internal external class ResizeObserver(callback: () -> Unit) {
    fun observe(target: Element)
    fun disconnect()
}
