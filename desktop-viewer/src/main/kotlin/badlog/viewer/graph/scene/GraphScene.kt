package badlog.viewer.graph.scene

import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateMapOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import badlog.analysis.Units
import badlog.plot.board.BoardGraph
import badlog.plot.path.Plane
import badlog.plot.timeline.EventTimeline
import badlog.viewer.axis.AxisChoice
import badlog.viewer.board.GraphBoard
import badlog.viewer.compare.ComparedRecordings
import badlog.viewer.compare.DrawnRecording
import badlog.viewer.field.FieldChoice
import badlog.viewer.findings.LogFindings
import badlog.viewer.graph.plot.PlotPicture
import badlog.viewer.graph.plot.PlotState
import badlog.viewer.graph.plot.Plots
import badlog.viewer.graph.plot.drawnLines
import badlog.viewer.note.LogNotes
import badlog.viewer.playback.Player
import badlog.viewer.recording.CurrentRecording
import badlog.viewer.recording.FilteredEvents
import badlog.viewer.settings.SettingsStore
import badlog.viewer.station.StationChoice
import badlog.viewer.view.AxisView
import kotlinx.coroutines.flow.first

/**
 * What all graphs of a window share.
 *
 * @property copy puts the picture of graphs onto the clipboard.
 * @property addTopics asks for topics to draw in the graph with this id.
 */
internal class GraphScene(
    val current: CurrentRecording,
    val board: GraphBoard,
    val view: AxisView,
    val compared: ComparedRecordings,
    val events: FilteredEvents,
    val findings: LogFindings,
    val notes: LogNotes,
    val player: Player,
    val settings: SettingsStore,
    val copy: (List<BoardGraph>) -> Unit,
    val addTopics: (Int) -> Unit,
    val axis: AxisChoice,
    val stations: StationChoice,
    val fields: FieldChoice,
) {
    /** The pictures of the graphs. */
    val plots = Plots()
    val gestures = PlotGestures(view, board, player)

    /** How far the graphs are scrolled. */
    val list = LazyListState()

    /** The graph that is dragged to another place, if any. */
    val drag = GraphDrag(board, list)

    /** What is drawn. */
    val recordings: List<DrawnRecording> get() = compared.drawn

    /** Whether signals are being dragged over the window. */
    var isReceiving: Boolean by mutableStateOf(false)

    /** The parts of their planes that graphs of y over x show, by their ids; all of it where there is none. */
    val planes = mutableStateMapOf<Int, Plane>()

    private val hasRightAxis by derivedStateOf { board.state.graphs.any { !it.isXy && unitsOf(it) > 1 } }

    /** The room at the right of all graphs: for the second axis, where any has one, and the scroll bar. */
    val rightGutter: Dp get() = if (hasRightAxis) 60.dp else 12.dp

    /** Scrolls by [share] of what is seen, up when negative. */
    fun scroll(share: Double) {
        list.dispatchRawDelta((list.layoutInfo.viewportSize.height * share).toFloat())
    }

    /** Waits until every graph in sight is drawn; returns at once while there is none. */
    suspend fun awaitDrawn() {
        snapshotFlow { board.state.graphs.isEmpty() || plots.areReady(recordings, view.viewport.visible) }.first { it }
    }

    /** What [state] has to draw; a picture of another file is as none. */
    fun pictureOf(state: PlotState): PlotPicture? =
        state.picture?.takeIf { it.request.recordings.firstOrNull()?.recording?.file == current.recording?.file }

    /** The other graphs whose limits of y [spec] shares; none where it does not. */
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
