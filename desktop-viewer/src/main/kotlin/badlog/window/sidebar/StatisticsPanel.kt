package badlog.window.sidebar

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.produceState
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import badlog.viewer.panel.Measured
import badlog.viewer.panel.MeasuredLine
import badlog.viewer.panel.NamedSpan
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.Table
import badlog.viewer.panel.Tone
import badlog.viewer.panel.rangeChoice
import badlog.viewer.panel.spanOf
import badlog.viewer.panel.statisticsOf
import badlog.viewer.panel.tsvOf
import badlog.viewer.shown.statistics.Channels
import badlog.viewer.state.StatisticsState
import badlog.viewer.text.shortNames
import badlog.window.compare.ComparedRecordings
import badlog.window.compare.DrawnRecording
import badlog.window.log.AxisView
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.panel.PanelView
import badlog.window.panel.PartView
import badlog.window.theme.Icons
import badlog.window.theme.ToolButton
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.withContext

/** The statistics of every drawn topic, see [statisticsOf]. */
@Composable
internal fun StatisticsPanel(compared: ComparedRecordings, board: GraphBoard, view: AxisView, open: OpenRecording, modifier: Modifier) {
    val known by produceState<Pair<NamedSpan, List<Part>>?>(null, open) {
        // While the selection is dragged, only the latest that there was time for is calculated.
        snapshotFlow { statisticsInput(compared, board, view, open) }.conflate().map { asked ->
            withContext(Dispatchers.Default) { asked.part to asked.parts(open) }
        }.collect { value = it }
    }
    val (part, parts) = known ?: return
    Column(modifier) {
        Head(part, parts, view, open)
        PanelView(parts, goal = null, view::send, Modifier.weight(1f))
    }
}

@Composable
private fun Head(part: NamedSpan, parts: List<Part>, view: AxisView, open: OpenRecording) {
    val copy = rememberCopy()
    Row(verticalAlignment = Alignment.CenterVertically) {
        PartView(rangeChoice(view.place, open.enabled, view.statistics), view::send, Modifier.weight(1f))
        ToolButton("Copy the statistics", Icons.Copy, text = "Copy") {
            copy(tsvOf(parts.filterIsInstance<Table>(), part))
        }
    }
}

/** The input of the statistics; while it stays equal, nothing is recalculated. */
internal data class StatisticsInput(
    val drawn: List<DrawnRecording>,
    val graphs: List<List<String>>,
    val part: NamedSpan,
    val state: StatisticsState,
    val unfolded: Map<String, Boolean>,
) {
    /** Returns the statistics; [open] is the open recording. */
    fun parts(open: OpenRecording): List<Part> {
        val tables = graphs.flatten().distinct().map { name -> drawn.indices.mapNotNull { lineOf(name, it) } }.filter { it.isNotEmpty() }
        val hint = Paragraph("none", "No topic is drawn. Click one in the list of topics.", Tone.MUTED)
        val together = graphs.filter { it.size > 1 }.distinct().flatMap { lines ->
            drawn.indices.map { place -> lines.zip(shortNames(lines)).mapNotNull { (name, short) -> lineOf(name, place, short) } }
        }
        val measured = Measured(tables, together, Channels.of(open.view, open.signalTopics))
        return statisticsOf(measured, part, open.view.xAxis, state, unfolded) + listOfNotNull(hint.takeIf { tables.isEmpty() })
    }

    private fun lineOf(name: String, place: Int, short: String = name): MeasuredLine? {
        val (recording, offset, log) = drawn[place]
        val signal = recording.signal(name)?.takeIf { it.hasFigures || it.states != null } ?: return null
        return if (drawn.size > 1) MeasuredLine(signal.line, short, place, log, offset) else MeasuredLine(signal.line, short, color = null)
    }
}

/** Returns the current input for [open]. */
internal fun statisticsInput(compared: ComparedRecordings, board: GraphBoard, view: AxisView, open: OpenRecording) = StatisticsInput(
    compared.drawn,
    board.state.graphs.map { it.lines },
    view.place.spanOf(view.statistics.range, open.enabled),
    view.statistics,
    view.unfolded,
)
