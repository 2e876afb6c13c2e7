package badlog.page.graph

import badlog.page.dom.bringIntoSight
import kotlinx.browser.window
import org.w3c.dom.DOMRect

/** Scrolls to [cards], the graphs of the page from top to bottom, and focuses them. */
internal class GraphsInSight(private val cards: () -> List<GraphCard>) {
    /** Scrolls to the first graph if none is on the screen, so that the cursor is visible. */
    fun showAny() {
        val boxes = cards().map { it.element to it.element.getBoundingClientRect() }.filter { (_, box) -> box.height > 0 }
        if (boxes.any { (_, box) -> isOnScreen(box) }) return
        boxes.firstOrNull()?.first?.bringIntoSight()
    }

    /** Focuses the first graph on the screen, without scrolling. */
    fun focusAny() {
        cards().find { isOnScreen(it.element.getBoundingClientRect()) }?.focusInPlace()
    }

    /** Focuses the first graph, and skips everything above it. */
    fun focusFirst() {
        val first = cards().firstOrNull { it.element.getBoundingClientRect().height > 0 } ?: return
        first.element.bringIntoSight()
        first.focus()
    }

    private fun isOnScreen(box: DOMRect) = box.height > 0 && box.bottom > MIN_VISIBLE && box.top < window.innerHeight - MIN_VISIBLE
}

/** The number of visible pixels of a graph that suffice to see its cursor. */
private const val MIN_VISIBLE = 120
