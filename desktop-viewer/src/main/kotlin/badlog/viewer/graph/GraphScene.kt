package badlog.viewer.graph

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import badlog.analysis.Units
import badlog.plot.timeline.EventTimeline
import badlog.viewer.app.Viewer
import badlog.viewer.compare.DrawnRecording
import badlog.viewer.compare.drawnRecordings
import badlog.viewer.graph.plot.PlotPicture
import badlog.viewer.graph.plot.PlotState
import badlog.viewer.graph.plot.Plots
import badlog.viewer.graph.plot.drawnLines

/** What all graphs of a window share. */
internal class GraphScene(val viewer: Viewer) {
    val plots: Plots get() = viewer.plots
    val gestures = PlotGestures(viewer)

    /** What is drawn. */
    val recordings: List<DrawnRecording> by derivedStateOf { viewer.drawnRecordings() }

    /** The events that are marked. */
    val events: EventTimeline get() = viewer.matchingEvents

    /** Whether signals are being dragged over the window. */
    var isReceiving: Boolean by mutableStateOf(false)

    private val hasRightAxis by derivedStateOf { viewer.graphs.graphs.any { unitsOf(it) > 1 } }

    /** The room at the right of all graphs: for the second axis, where any has one, and the scroll bar. */
    val rightGutter: Dp get() = if (hasRightAxis) 60.dp else 12.dp

    /** What [state] has to draw; a picture of another file is as none. */
    fun pictureOf(state: PlotState): PlotPicture? =
        state.picture?.takeIf { it.request.recordings.firstOrNull()?.recording?.file == viewer.open?.file }

    private fun unitsOf(spec: GraphSpec) = drawnLines(spec, recordings)
        .filter { it.signal.states == null }
        .distinctBy { if (Units.isNone(it.signal.unit)) "" else it.signal.unit }
        .size

    companion object {
        /** The room at the left of all graphs, for the axis. */
        val LEFT_GUTTER = 68.dp
    }
}
