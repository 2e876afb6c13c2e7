package badlog.window.graph.scene

import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateMapOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import badlog.core.analysis.Units
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.Plane
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
