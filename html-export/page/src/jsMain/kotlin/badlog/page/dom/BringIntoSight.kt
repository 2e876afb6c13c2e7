package badlog.page.dom

import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element

/**
 * Scrolls to this element. Anything in between is laid out only when it comes near, and may turn out taller than estimated, so
 * this is repeated once it is laid out. Scrolls only this page, not another one that shows it in a frame.
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

/** Gives this element the keyboard's focus. Nothing scrolls. */
internal fun Element.focusInPlace() = asDynamic().focus(json("preventScroll" to true)).unsafeCast<Unit>()
