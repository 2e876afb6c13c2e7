package badlog.page.dom

import kotlinx.browser.window
import org.w3c.dom.Element

/**
 * Scrolls to this element. What lies between is laid out only as it comes near, and may turn out taller than it was taken for, so
 * this is done again once it is.
 */
internal fun Element.bringIntoSight() {
    fun scroll() = asDynamic().scrollIntoView(json("behavior" to "instant"))
    scroll()
    window.requestAnimationFrame { window.requestAnimationFrame { scroll() } }
}
