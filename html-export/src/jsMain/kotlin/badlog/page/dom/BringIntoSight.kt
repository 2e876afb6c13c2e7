package badlog.page.dom

import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element

/**
 * Scrolls to this element. What lies between is laid out only as it comes near, and may turn out taller than it was taken for, so
 * this is done again once it is. Scrolls the page alone, and no other that shows this one in a frame.
 */
internal fun Element.bringIntoSight() {
    fun scroll() {
        val below = window.getComputedStyle(document.documentElement!!).asDynamic().scrollPaddingTop.unsafeCast<String>()
        val top = window.scrollY + getBoundingClientRect().top - (below.removeSuffix("px").toDoubleOrNull() ?: 0.0)
        window.asDynamic().scrollTo(json("top" to top, "behavior" to "instant"))
    }
    scroll()
    window.requestAnimationFrame { window.requestAnimationFrame { scroll() } }
}
