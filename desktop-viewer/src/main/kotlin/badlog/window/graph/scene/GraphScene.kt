package badlog.window.graph.scene

import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateMapOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import badlog.core.analysis.Units
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.Plane
import badlog.viewer.state.GraphChange
import badlog.window.choice.AxisChoice
import badlog.window.choice.FieldChoice
import badlog.window.choice.StationChoice
import badlog.window.compare.ComparedRecordings
import badlog.window.compare.DrawnRecording
import badlog.window.findings.CurrentFindings
import badlog.window.graph.plot.PlotPicture
import badlog.window.graph.plot.PlotState
import badlog.window.graph.plot.Plots
import badlog.window.graph.plot.drawnLines
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.FilteredEvents
import badlog.window.log.GraphBoard
import badlog.window.log.LiveView
import badlog.window.log.LogNotes
import badlog.window.settings.SettingsStore
import badlog.window.video.Player
import kotlinx.coroutines.flow.first

/**
 * The state that all graphs of a window share.
 *
 * @property copy copies the picture of graphs to the clipboard.
 * @property addTopics asks for topics to draw in the graph with the given id.
 */
internal class GraphScene(
    val current: CurrentRecording,
    val board: GraphBoard,
    val view: AxisView,
    val compared: ComparedRecordings,
    val events: FilteredEvents,
    val findings: CurrentFindings,
    val notes: LogNotes,
    val player: Player,
    val settings: SettingsStore,
    val copy: (List<BoardGraph>) -> Unit,
    val addTopics: (Int) -> Unit,
    val axis: AxisChoice,
    val stations: StationChoice,
    val fields: FieldChoice,
    val live: LiveView,
) {
    /** The pictures of the graphs. */
    val plots = Plots()

    /** The scroll state of the graphs. */
    val list = LazyListState()

    /** The drag of a graph to another place. */
    val drag = GraphDrag(board, list)

    /** The drawn recordings. */
    val recordings: List<DrawnRecording> get() = compared.drawn

    /** Whether signals are being dragged over the window. */
    var isReceiving: Boolean by mutableStateOf(false)

    /** Whether the graphs are to get the keyboard's focus, because a person has opened a log. */
    var isFocusAsked: Boolean by mutableStateOf(false)

    /** The visible part of the plane of each graph of y over x, by the graph's id. A graph without an entry shows its whole plane. */
    val planes = mutableStateMapOf<Int, Plane>()

    private val hasRightAxis by derivedStateOf { board.state.graphs.any { !it.isXy && unitsOf(it) > 1 } }

    /** The room to the right of all graphs, for the scroll bar, and for the second axis if any graph has one. */
    val rightGutter: Dp get() = if (hasRightAxis) 60.dp else 12.dp

    /** Scrolls by [share] of the visible height, up if negative. */
    fun scroll(share: Double) {
        list.dispatchRawDelta((list.layoutInfo.viewportSize.height * share).toFloat())
    }

    /** Waits until every graph in sight is drawn; returns at once if there is none. */
    suspend fun awaitDrawn() {
        snapshotFlow { board.state.graphs.isEmpty() || plots.areReady(recordings, view.viewport.visible) }.first { it }
    }

    /** Returns the picture to draw for [state]; null if there is none for the open file. */
    fun pictureOf(state: PlotState): PlotPicture? =
        state.picture?.takeIf { it.request.recordings.firstOrNull()?.recording?.file == current.recording?.file }

    /** Returns the other graphs that share y limits with [spec]; none if it does not share them. */
    fun sharingWith(spec: BoardGraph): List<BoardGraph> =
        if (spec.sharesY) board.state.graphs.filter { it.sharesY && it.id != spec.id } else emptyList()

    private fun unitsOf(spec: BoardGraph) = drawnLines(spec, recordings)
        .filter { it.signal.states == null && it.signal.name !in spec.hidden }
        .distinctBy { if (Units.isNone(it.signal.unit)) "" else it.signal.unit }
        .size

    companion object {
        /** The room at the left of all graphs, for the axis. */
        val LEFT_GUTTER = 68.dp

        /** The height of the line above a graph, in dp. */
        const val HEADER_HEIGHT = 22
    }
}

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
