package badlog.window.sidebar

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.board.Board
import badlog.viewer.panel.Button
import badlog.viewer.panel.CursorLine
import badlog.viewer.panel.Part
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.cursorPanel
import badlog.viewer.shown.cursor.CursorValues
import badlog.viewer.shown.search.Query
import badlog.viewer.state.GraphChange
import badlog.viewer.text.cursorText
import badlog.viewer.text.unitText
import badlog.window.findings.CurrentFindings
import badlog.window.log.AxisView
import badlog.window.log.DrawableTopic
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.log.isFoundBy
import badlog.window.panel.PanelView
import badlog.window.theme.SearchField
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.withContext

/** The values at the cursor of the graphs' topics, or of those that a search finds, see [cursorPanel]. */
@Composable
internal fun CursorPanel(board: GraphBoard, findings: CurrentFindings, view: AxisView, open: OpenRecording, modifier: Modifier) {
    var query by remember { mutableStateOf("") }
    val parts by produceState(emptyList<Part>(), open) {
        var asked: Pair<List<DrawableTopic>, Board>? = null
        var lines = emptyList<CursorLine>()
        var values = CursorValues(emptyList(), open.view.xAxis)
        snapshotFlow {
            CursorQuestion(query, board.state, findings.state.topics, view.cursor, view.viewport.visible.width)
        }.conflate().map { (query, graphs, found, x, width) ->
            withContext(Dispatchers.Default) {
                val signals = cursorSignals(open, graphs, query, found)
                if (signals to graphs != asked) {
                    lines = signals.map { CursorLine(it.name, it.line, pinOf(it.name, graphs)) }
                    values = CursorValues(lines.map { it.line }, open.view.xAxis)
                }
                asked = signals to graphs
                cursorPanel(lines, values, x, x?.let { cursorText(it, open.view.xAxis, width, open.clocks.textAt(it)) }.orEmpty())
            }
        }.collect { value = it }
    }
    Column(modifier) {
        SearchField(query, "Search topics", Modifier.fillMaxWidth().padding(8.dp)) { query = it }
        PanelView(parts, goal = null, { action ->
            val drawn = (action as? GraphChange.Add)?.let { change -> board.state.graphs.find { it.lines.containsAll(change.lines) } }
            if (drawn != null) board.goTo(drawn.id) else view.send(action)
        }, Modifier.weight(1f))
    }
}

private data class CursorQuestion(val query: String, val graphs: Board, val found: Set<String>, val x: Double?, val width: Double)

/** Returns the button that draws [name], or goes to its graph on [board]. */
private fun pinOf(name: String, board: Board): Button {
    val isDrawn = board.graphs.any { name in it.lines }
    return Button(if (isDrawn) "Go to the graph of $name" else "Draw $name", GraphChange.Add(listOf(name)), PartIcon.PIN, isOn = isDrawn)
}

/**
 * Returns the topics with a name or unit that [query] matches. Without a query, it returns the topics in the graphs of [board].
 *
 * @param found the names of the topics that a finding is about.
 */
internal fun cursorSignals(open: OpenRecording, board: Board, query: String, found: Set<String> = emptySet()): List<DrawableTopic> {
    val wanted = Query(query)
    if (wanted.isEmpty) return board.graphs.flatMap { it.lines }.distinct().mapNotNull(open::signal)
    return open.signals.filter { (it.hasFigures || it.states != null) && it.isFoundBy(wanted, found, "${it.name} ${unitText(it.unit)}") }
}
