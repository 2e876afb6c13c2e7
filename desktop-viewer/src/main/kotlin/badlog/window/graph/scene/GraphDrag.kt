package badlog.window.graph.scene

import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.geometry.Offset
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.state.GraphChange
import badlog.window.log.GraphBoard

/**
 * The drag of a graph by its title: to another place on the board, or into another graph. Use it only on the window's thread.
 *
 * @param list the scroll state of the graphs.
 */
internal class GraphDrag(private val board: GraphBoard, private val list: LazyListState) {
    private var pressed: Int? = null
    private var start = Offset.Zero
    private var id: Int? by mutableStateOf(null)

    /** The pointer's place, in pixels from the top left corner of the visible part of the graphs. */
    var pointer: Offset by mutableStateOf(Offset.Zero)
        private set

    /** The dragged graph; null for none. */
    val graph: BoardGraph? get() = id?.let { dragged -> board.state.graphs.find { it.id == dragged } }

    /** The graph under the pointer, or the nearest one above or below it; null while nothing is dragged. */
    val target: DropTarget? by derivedStateOf { if (id == null) null else targetAt(pointer.y) }

    /** Handles a press at [place]. */
    fun pressAt(place: Offset) {
        pressed = null
        start = place
    }

    /** Records that the press was on the title of graph [id]. */
    fun take(id: Int) {
        pressed = id
    }

    /** Handles a move of the pressed pointer to [place]. Returns whether it is a drag, which begins at the distance [reach]. */
    fun move(place: Offset, reach: Float): Boolean {
        val taken = pressed ?: return false
        if (id == null && (place - start).getDistance() < reach) return false
        id = taken
        pointer = place
        return true
    }

    /** Handles the release of the pointer. Returns whether something was dragged. */
    fun release(): Boolean {
        val dragged = id
        val onto = target
        cancel()
        if (dragged != null && onto != null) board.send(GraphChange.Drop(dragged, onto.id, onto.share))
        return dragged != null
    }

    /** Ends the drag, and leaves the graph where it was. */
    fun cancel() {
        pressed = null
        id = null
    }

    private fun targetAt(y: Float): DropTarget? {
        val cards = list.layoutInfo.visibleItemsInfo.filter { it.key is Int }
        val card = cards.firstOrNull { y < it.offset + it.size } ?: cards.lastOrNull() ?: return null
        return DropTarget(card.key as Int, card.offset, card.size, ((y - card.offset) / card.size).toDouble().coerceIn(0.0, 1.0))
    }
}

/**
 * A graph over which another one is dragged.
 *
 * @property top its upper edge, in pixels from the top of the visible part of the graphs.
 * @property height its height in pixels.
 * @property share the pointer's distance from its upper edge as a share of its height, 0 to 1.
 */
internal class DropTarget(val id: Int, val top: Int, val height: Int, val share: Double)
