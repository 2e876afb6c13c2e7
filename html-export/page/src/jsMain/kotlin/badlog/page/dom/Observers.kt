package badlog.page.dom

import org.w3c.dom.Element

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
