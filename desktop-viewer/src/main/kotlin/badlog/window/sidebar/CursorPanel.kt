package badlog.window.sidebar

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.board.Board
import badlog.viewer.shown.cursor.CursorValues
import badlog.viewer.shown.search.Query
import badlog.viewer.state.GraphChange
import badlog.viewer.text.cursorText
import badlog.viewer.text.exactText
import badlog.viewer.text.unitText
import badlog.window.findings.CurrentFindings
import badlog.window.log.AxisView
import badlog.window.log.DrawableTopic
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.log.isFoundBy
import badlog.window.log.valueText
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.SearchField
import badlog.window.theme.Tip
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.withContext

/** The values at the cursor of the graphs' topics, or of those that a search finds; recently changed ones first. */
@Composable
internal fun CursorPanel(board: GraphBoard, findings: CurrentFindings, view: AxisView, open: OpenRecording, modifier: Modifier) {
    var query by remember { mutableStateOf("") }
    val rows by produceState(emptyList<CursorRow>(), open) {
        var asked = emptyList<DrawableTopic>()
        var values = CursorValues(emptyList(), open.view.xAxis)
        snapshotFlow {
            CursorQuestion(query, board.state, findings.state.topics, view.cursor)
        }.conflate().map { (query, graphs, found, x) ->
            withContext(Dispatchers.Default) {
                val signals = cursorSignals(open, graphs, query, found)
                if (signals != asked) values = CursorValues(signals.map { it.line }, open.view.xAxis)
                asked = signals
                cursorRows(signals, values, x)
            }
        }.collect { value = it }
    }
    val state = rememberLazyListState()
    val axis = open.view.xAxis
    Column(modifier) {
        SearchField(query, "Search topics", Modifier.fillMaxWidth().padding(8.dp)) { query = it }
        val x = view.cursor
        if (x == null) {
            PanelHint("Point at a graph, or click it.")
        } else {
            Text(
                cursorText(x, axis, view.viewport.visible.width, open.clocks.textAt(x)),
                Modifier.padding(horizontal = 12.dp, vertical = 2.dp),
                color = LocalPalette.current.muted,
            )
        }
        Box(Modifier.fillMaxSize()) {
            val drawn = remember(board.state) { board.state.graphs.flatMap { graph -> graph.lines.map { it to graph.id } }.toMap() }
            LazyColumn(Modifier.fillMaxSize(), state) {
                items(rows) { row ->
                    CursorLine(row, isDrawn = row.name in drawn) {
                        drawn[row.name]?.let(board::goTo) ?: board.send(GraphChange.Add(listOf(row.name)))
                    }
                }
            }
            VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

private data class CursorQuestion(val query: String, val graphs: Board, val found: Set<String>, val x: Double?)

/**
 * A line of the panel: the [name] of a topic and its value, also [exact] to the last digit. [hasChanged] is true if the value has just
 * changed.
 */
internal data class CursorRow(val name: String, val text: String, val exact: String, val hasChanged: Boolean)

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

/** Returns the values of [signals] at [x], in the order of [values]. */
internal fun cursorRows(signals: List<DrawableTopic>, values: CursorValues, x: Double?): List<CursorRow> =
    values.at(x ?: Double.NaN).map { value ->
        val signal = signals[value.line]
        if (x == null) return@map CursorRow(signal.name, "", "", value.hasChanged)
        CursorRow(signal.name, valueText(signal, x), valueText(signal, x, ::exactText), value.hasChanged)
    }

/** A topic, its value, and a pin that draws it, or goes to its graph if [isDrawn]. */
@Composable
private fun CursorLine(row: CursorRow, isDrawn: Boolean, onPin: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier.fillMaxWidth()
            .background(if (row.hasChanged) palette.accentSoft else Color.Transparent)
            .padding(start = 12.dp, end = 14.dp, top = 1.dp, bottom = 1.dp),
        horizontalArrangement = Arrangement.spacedBy(8.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Icon(
            Icons.Pin,
            if (isDrawn) "Go to the graph of ${row.name}" else "Draw ${row.name}",
            Modifier.size(14.dp).clickable(role = Role.Button, onClick = onPin),
            if (isDrawn) palette.accent else palette.muted,
        )
        NameText(row.name, Modifier.weight(1f), color = palette.muted)
        Tip(row.exact, Modifier.weight(0.8f)) {
            Text(row.text, fontWeight = FontWeight.Medium, maxLines = 1, overflow = TextOverflow.Ellipsis)
        }
    }
}
