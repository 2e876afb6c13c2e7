package badlog.page.dom

import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element

/**
 * Scrolls to this element, and again once the page is laid out. Elements in between are laid out only near the screen, and may be taller
 * than estimated. Only this page scrolls, not a page that shows it in a frame.
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

/** Focuses this element without scrolling. */
internal fun Element.focusInPlace() = asDynamic().focus(json("preventScroll" to true)).unsafeCast<Unit>()
