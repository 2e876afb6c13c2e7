package badlog.page.graph

import badlog.page.dom.IntersectionObserver
import badlog.page.dom.json
import badlog.page.view.Frame
import badlog.page.view.Scene
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element

/**
 * All graphs of the page: draws those near the screen, and lets all of them follow the visible range and the cursor.
 */
internal class VisibleGraphs(private val scene: Scene) {
    private val cardOf = HashMap<Element, GraphCard>()
    private val near = LinkedHashSet<GraphCard>()
    private val observer = IntersectionObserver({ entries ->
        val isNear = LinkedHashMap<GraphCard, Boolean>()
        // One that was removed may still be reported, and one that comes and goes twice.
        for (entry in entries) cardOf[entry.target]?.let { isNear[it] = entry.isIntersecting }
        val (coming, going) = isNear.keys.partition { isNear[it] == true }
        for (card in going) part(card)
        meet(coming)
    }, json("rootMargin" to MARGIN))
    private val zoomFrame = Frame(::drawZoom)
    private val restFrame = Frame(::drawRest)
    private val cursorFrame = Frame { for (card in near) card.updateCursor() }
    private var zoomedAt = Double.NaN
    private var zooms = 0

    init {
        scene.range.onChange {
            if (zoomedAt.isNaN()) zoomedAt = window.performance.now()
            zoomFrame.ask()
        }
        scene.cursor.onChange { cursorFrame.ask() }
        followDensity()
    }

    /** Draws what of [cards] is on the screen at once, and from now on whatever comes near it. */
    fun start(cards: List<GraphCard>) {
        meet(
            cards.filter { card ->
                val box = card.element.getBoundingClientRect()
                box.height > 0 && box.top < window.innerHeight
            },
        )
        for (card in cards) add(card)
    }

    /** Draws [card] from now on whenever it comes near the screen. */
    fun add(card: GraphCard) {
        cardOf[card.element] = card
        observer.observe(card.element)
    }

    /** Forgets [card]. */
    fun remove(card: GraphCard) {
        observer.unobserve(card.element)
        cardOf.remove(card.element)
        part(card)
    }

    /** What draws [element]; null where that is not a graph. */
    fun cardAt(element: Element): GraphCard? = cardOf[element]

    /** Shows of each graph whether it is on the board. */
    fun updatePins() {
        for (card in near) card.updatePin()
    }

    /** Draws everything again where it is. */
    fun redraw() {
        for (card in near) card.outdate()
        draw(near)
    }

    /** Draws everything again with the colors and the screen of now. */
    fun repaint() {
        for (card in near) card.repaint()
    }

    private fun meet(cards: List<GraphCard>) {
        // All widths are read before anything is drawn: the browser lays out the page for each that is read after something was written.
        val widths = cards.map { it.room }
        cards.forEachIndexed { i, card ->
            near += card
            card.approach(widths[i])
            card.updatePin()
        }
        draw(cards)
    }

    private fun draw(cards: Collection<GraphCard>) {
        for (card in cards) card.refresh()
        // Last: the browser works out the page's style anew for the first letters that are drawn after something was written to it.
        for (card in cards) card.placeCursors()
    }

    /** Draws again when the window moves to a screen of another density, or is zoomed. */
    private fun followDensity() {
        val ratio = window.devicePixelRatio
        val isSame = "(min-resolution: ${ratio - ROUNDING}dppx) and (max-resolution: ${ratio + ROUNDING}dppx)"
        window.matchMedia(isSame).asDynamic().addEventListener("change", {
            repaint()
            followDensity()
        }, json("once" to true))
    }

    private fun part(card: GraphCard) {
        near -= card
        card.leave()
    }

    private fun drawZoom() {
        val begin = window.performance.now()
        for (card in near) card.outdate()
        draw(near.filter { it.isOnScreen })
        window.performance.asDynamic().measure("badlog-zoom", json("start" to zoomedAt))
        window.performance.asDynamic().measure("badlog-zoom-script", json("start" to begin))
        document.documentElement?.setAttribute("data-zoomed", (++zooms).toString())
        zoomedAt = Double.NaN
        restFrame.ask()
    }

    // What is beside the screen can wait for a picture of its own.
    private fun drawRest() = draw(near)

    private companion object {
        const val MARGIN = "300px 0px"

        /** So exactly do browsers compare densities. */
        const val ROUNDING = 0.001
    }
}
