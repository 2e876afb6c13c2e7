package badlog.window.graph

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.itemsIndexed
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.isCtrlPressed
import androidx.compose.ui.input.pointer.isMetaPressed
import androidx.compose.ui.input.pointer.isShiftPressed
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.board.BoardGraph
import badlog.window.graph.mark.EventLabel
import badlog.window.graph.mark.FindingLabel
import badlog.window.graph.plot.OVERVIEW
import badlog.window.graph.plot.drawnLines
import badlog.window.graph.scene.GraphScene
import badlog.window.log.GraphBoard
import badlog.window.theme.LocalPalette

/** The graphs from top to bottom. */
@Composable
internal fun GraphColumn(scene: GraphScene) {
    val graphs = scene.board.state.graphs
    val recordings = scene.recordings
    SideEffect { scene.plots.keep(graphs.mapTo(HashSet()) { it.id } + OVERVIEW, recordings) }
    BoxWithConstraints(Modifier.fillMaxSize().changesHeights(scene).dragsGraphs(scene.drag, LocalPalette.current)) {
        val scroll = scene.list
        ShowWantedGraph(scene.board, scroll)
        val lanes = remember(graphs, scene.recordings) { graphs.map { lanesOf(it, scene) } }
        val settings = scene.settings.state
        val heights = graphHeights(graphs, lanes, maxHeight.value.toInt(), settings.graphHeight, settings.fitsGraphs)
        LazyColumn(Modifier.fillMaxSize(), scroll) {
            itemsIndexed(graphs, key = { _, graph -> graph.id }) { index, graph ->
                GraphCard(scene, graph, heights.getOrElse(index) { BoardGraph.HEIGHTS.first })
            }
            if (scene.isReceiving) item { NewGraphPlace() }
        }
        VerticalScrollbar(rememberScrollbarAdapter(scroll), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        EventLabel(scene)
        FindingLabel(scene, Modifier.align(Alignment.BottomStart))
        SelectionChip(scene, maxWidth)
        DraggedGraph(scene, constraints.maxHeight)
    }
}

/** Scrolls to the wanted graph of [board], and reports the visible graphs. */
@Composable
private fun ShowWantedGraph(board: GraphBoard, scroll: LazyListState) {
    LaunchedEffect(board.wanted) {
        val place = board.state.graphs.indexOfFirst { it.id == board.wanted }
        if (place >= 0) scroll.scrollToItem(place)
        board.goTo(null)
    }
    DisposableEffect(board) { onDispose { board.inSight = null } }
    LaunchedEffect(board, scroll) {
        snapshotFlow {
            val seen = scroll.layoutInfo
            val middles = seen.visibleItemsInfo.associate { it.key to it.offset + it.size / 2 }
            middles.filterValues { it in seen.viewportStartOffset..seen.viewportEndOffset }.keys.filterIsInstance<Int>().toSet()
        }.collect { board.inSight = it }
    }
}

/** The place below the last graph for a new one, shown while signals are being dragged. */
@Composable
private fun NewGraphPlace() {
    Text(
        "Drop here for a new graph; on a graph's title for one above it",
        Modifier.fillMaxWidth().padding(24.dp),
        color = LocalPalette.current.muted,
        textAlign = TextAlign.Center,
    )
}

private fun lanesOf(spec: BoardGraph, scene: GraphScene): Int {
    val lines = drawnLines(spec, scene.recordings).filter { it.signal.name !in spec.hidden }
    return if (lines.isNotEmpty() && lines.all { it.signal.states != null }) lines.size else 0
}

/** Makes graphs taller or shorter with Ctrl, Shift, and the wheel, wherever the pointer is. */
private fun Modifier.changesHeights(scene: GraphScene) = pointerInput(scene) {
    awaitPointerEventScope {
        while (true) {
            val event = awaitPointerEvent(PointerEventPass.Initial)
            val isCtrl = event.keyboardModifiers.isCtrlPressed || event.keyboardModifiers.isMetaPressed
            if (event.type != PointerEventType.Scroll || !isCtrl || !event.keyboardModifiers.isShiftPressed) continue
            // Some systems report the wheel as horizontal while Shift is held.
            val notches = event.changes.sumOf { (it.scrollDelta.x + it.scrollDelta.y).toDouble() }
            event.changes.forEach { it.consume() }
            setGraphHeight(scene.settings, scene.settings.state.graphHeight - (notches * DP_PER_NOTCH).toInt())
        }
    }
}

private const val DP_PER_NOTCH = 12
