package badlog.page.graph

import badlog.page.dom.bringIntoSight
import kotlinx.browser.window
import org.w3c.dom.DOMRect

/** Brings one of [cards], the graphs of the page from top to bottom, into sight. */
internal class GraphsInSight(private val cards: () -> List<GraphCard>) {
    /** Scrolls to the first graph if none is on the screen, so that the cursor is visible. */
    fun showAny() {
        val boxes = cards().map { it.element to it.element.getBoundingClientRect() }.filter { (_, box) -> box.height > 0 }
        if (boxes.any { (_, box) -> isOnScreen(box) }) return
        boxes.firstOrNull()?.first?.bringIntoSight()
    }

    /** Gives the first graph on the screen the focus. Nothing scrolls. */
    fun focusAny() {
        cards().find { isOnScreen(it.element.getBoundingClientRect()) }?.focusInPlace()
    }

    /** Gives the first graph the focus, past all that stands above it. */
    fun focusFirst() {
        val first = cards().firstOrNull { it.element.getBoundingClientRect().height > 0 } ?: return
        first.element.bringIntoSight()
        first.focus()
    }

    private fun isOnScreen(box: DOMRect) = box.height > 0 && box.bottom > MIN_VISIBLE && box.top < window.innerHeight - MIN_VISIBLE

    private companion object {
        /** The number of pixels of a graph that are enough to see its cursor. */
        const val MIN_VISIBLE = 120
    }
}
