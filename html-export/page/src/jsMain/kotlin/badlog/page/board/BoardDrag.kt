package badlog.page.board

import badlog.page.dom.EscapeKey
import badlog.page.dom.PageEvents
import badlog.page.dom.addName
import badlog.page.dom.element
import badlog.page.graph.GraphCard
import badlog.page.graph.VisibleGraphs
import badlog.page.view.PageBoard
import badlog.viewer.choices.board.asBoardGraph
import badlog.viewer.choices.board.isDroppedInto
import badlog.viewer.input.DragKind
import badlog.viewer.state.GraphChange
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.HTMLElement
import org.w3c.dom.pointerevents.PointerEvent
import kotlin.math.abs

/**
 * Drags a graph by its title with the mouse. Dropped on another graph, it is combined with that; dropped between graphs of the board, it is
 * placed there. Touch and keyboard users have menus instead.
 */
internal class BoardDrag(private val board: PageBoard, private val graphs: VisibleGraphs, private val section: BoardSection) {
    private var dragged: GraphCard? = null
    private var startX = 0.0
    private var startY = 0.0
    private var ghost: HTMLElement? = null
    private var marked: HTMLElement? = null
    private var drop: (() -> Unit)? = null
    private val escape = EscapeKey(::stop)

    init {
        PageEvents.on(document, "pointerdown") { press(it.unsafeCast<PointerEvent>()) }
        PageEvents.on(document, "pointermove") { move(it.unsafeCast<PointerEvent>()) }
        PageEvents.on(document, "pointerup") { release() }
        PageEvents.on(document, "pointercancel") { stop() }
    }

    private fun press(event: PointerEvent) {
        val title = event.target.unsafeCast<Element>().closest(".graph-title")
        if (event.button.toInt() != 0 || event.pointerType == "touch" || title == null) return
        dragged = title.closest(".graph")?.let(graphs::cardAt)
        startX = event.clientX.toDouble()
        startY = event.clientY.toDouble()
    }

    private fun move(event: PointerEvent) {
        val card = dragged ?: return
        val x = event.clientX.toDouble()
        val y = event.clientY.toDouble()
        if (ghost == null) {
            if (maxOf(abs(x - startX), abs(y - startY)) < DragKind.MIN_DISTANCE) return
            ghost = element("div", "drag-ghost card") { addName(card.title) }.also { document.body?.appendChild(it) }
            document.body?.classList?.add("is-dragging")
            escape.take()
        }
        ghost?.style?.transform = "translate(${x + GAP}px, ${y + GAP}px)"
        if (y < EDGE_TOP) {
            window.scrollBy(0.0, -SCROLL)
        } else if (y > window.innerHeight - EDGE_BOTTOM) {
            window.scrollBy(0.0, SCROLL)
        }
        aim(card, y, document.elementFromPoint(x, y))
    }

    /** Determines and shows the effect of dropping the graph here. */
    private fun aim(card: GraphCard, y: Double, below: Element?) {
        drop = null
        val own = section.itemOf(card.element)
        val onBoard = below?.closest("#board") != null
        val (item, share) = section.itemAt(y)?.takeIf { onBoard } ?: (null to 0.0)
        val isOnGraph = item != null && item !== own && isDroppedInto(share)
        when {
            item != null && isOnGraph -> mark(item.element, "drop-into") { join(card, own, item.spec.id) }

            item != null -> {
                val isBefore = share < 0.5
                val before = if (isBefore) item.spec.id else section.after(item)
                mark(item.element, if (isBefore) "drop-before" else "drop-after") { place(card, own, before) }
            }

            onBoard -> mark(section.element, "drop-after") { place(card, own, null) }

            else -> {
                val other = below?.closest(".graph")?.let(graphs::cardAt)?.takeIf { it !== card }
                if (other == null) mark(null) else mark(other.element, "drop-into") { both(card, other) }
            }
        }
    }

    private fun place(card: GraphCard, own: BoardItem?, before: Int?) =
        board.send(if (own == null) GraphChange.AddAll(listOf(card.look), before) else GraphChange.MoveBefore(own.spec.id, before))

    private fun join(card: GraphCard, own: BoardItem?, target: Int) =
        board.send(if (own != null) GraphChange.Join(target, own.spec.id) else GraphChange.AddLines(target, card.look.lines))

    private fun both(card: GraphCard, other: GraphCard) {
        val first = other.graph.asBoardGraph()
        board.send(GraphChange.AddAll(listOf(first.copy(lines = (first.lines + card.look.lines).distinct()))))
        section.bringIntoSight()
    }

    private fun mark(place: HTMLElement?, how: String = "", what: (() -> Unit)? = null) {
        marked?.classList?.remove("drop-into", "drop-before", "drop-after")
        place?.classList?.add(how)
        marked = place
        drop = what
    }

    private fun release() {
        val action = drop
        stop()
        action?.invoke()
    }

    private fun stop() {
        if (ghost != null) escape.giveBack()
        ghost?.remove()
        ghost = null
        dragged = null
        document.body?.classList?.remove("is-dragging")
        mark(null)
    }
}

private const val GAP = 10
private const val EDGE_TOP = 120
private const val EDGE_BOTTOM = 40
private const val SCROLL = 16.0
