package badlog.page.graph

import badlog.page.dom.IntersectionObserver
import badlog.page.dom.PageEvents
import badlog.page.dom.json
import badlog.page.view.Frame
import badlog.page.view.Scene
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.events.EventTarget

/** All graphs of the page. It draws the graphs near the screen, and makes all of them follow the visible range and the cursor. */
internal class VisibleGraphs(private val scene: Scene) {
    private val cardOf = HashMap<Element, GraphCard>()
    private val near = LinkedHashSet<GraphCard>()
    private val observer = IntersectionObserver({ entries ->
        val isNear = LinkedHashMap<GraphCard, Boolean>()
        // A removed element may still be reported, and one that comes and goes may be reported twice.
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

    /** Draws the [cards] on the screen at once, and others when they come near it. */
    fun start(cards: List<GraphCard>) {
        meet(
            cards.filter { card ->
                val box = card.element.getBoundingClientRect()
                box.height > 0 && box.top < window.innerHeight
            },
        )
        for (card in cards) add(card)
    }

    /** Adds [card], which is drawn whenever it comes near the screen. */
    fun add(card: GraphCard) {
        cardOf[card.element] = card
        observer.observe(card.element)
    }

    /** Removes [card]. */
    fun remove(card: GraphCard) {
        observer.unobserve(card.element)
        cardOf.remove(card.element)
        part(card)
    }

    /** Returns the card of [element]; null if that is not a graph. */
    fun cardAt(element: Element): GraphCard? = cardOf[element]

    /** Updates the pin button of each graph. */
    fun updatePins() {
        for (card in near) card.updatePin()
    }

    /** Redraws everything. */
    fun redraw() {
        for (card in near) card.outdate()
        draw(near)
    }

    /** Redraws everything with the lines of the currently compared logs. */
    fun renew() {
        for (card in cardOf.values) card.renew()
    }

    /** Redraws everything with the current colors, for the current screen. */
    fun repaint() {
        for (card in near) card.repaint()
    }

    private fun meet(cards: List<GraphCard>) {
        // Reads all widths before anything is drawn: after each write, reading one makes the browser lay out the page.
        val widths = cards.map { it.picture.room }
        cards.forEachIndexed { i, card ->
            near += card
            card.picture.approach(widths[i])
            card.updatePin()
        }
        draw(cards)
    }

    private fun draw(cards: Collection<GraphCard>) {
        for (card in cards) card.picture.refresh()
        // Last, because after each write to the page, the browser recalculates its style for the first text that is drawn.
        for (card in cards) card.picture.placeCursors()
    }

    /** Redraws when the window moves to a screen of another density, or is zoomed. */
    private fun followDensity() {
        val ratio = window.devicePixelRatio
        val isSame = "(min-resolution: ${ratio - ROUNDING}dppx) and (max-resolution: ${ratio + ROUNDING}dppx)"
        PageEvents.once(window.matchMedia(isSame).unsafeCast<EventTarget>(), "change") {
            repaint()
            followDensity()
        }
    }

    private fun part(card: GraphCard) {
        near -= card
        card.picture.leave()
    }

    private fun drawZoom() {
        val begin = window.performance.now()
        for (card in near) card.outdate()
        draw(near.filter { it.picture.isOnScreen })
        window.performance.asDynamic().measure("badlog-zoom", json("start" to zoomedAt))
        window.performance.asDynamic().measure("badlog-zoom-script", json("start" to begin))
        document.documentElement?.setAttribute("data-zoomed", (++zooms).toString())
        zoomedAt = Double.NaN
        restFrame.ask()
    }

    // Draws the graphs outside the screen in a later frame.
    private fun drawRest() = draw(near)
}

private const val MARGIN = "300px 0px"

/** The tolerance for comparing pixel densities, in dppx, because browsers round them. */
private const val ROUNDING = 0.001
