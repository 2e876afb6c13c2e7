package badlog.window.graph

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.itemsIndexed
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.composed
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.isCtrlPressed
import androidx.compose.ui.input.pointer.isMetaPressed
import androidx.compose.ui.input.pointer.isShiftPressed
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.layout
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.draw.lane.LaneLook
import badlog.viewer.state.BoardAction
import badlog.viewer.state.GraphChange
import badlog.viewer.state.PlaceAction
import badlog.viewer.text.lengthText
import badlog.window.choice.AxisOffer
import badlog.window.choice.StationOffer
import badlog.window.graph.mark.EventLabel
import badlog.window.graph.mark.FindingLabel
import badlog.window.graph.mark.FindingStrip
import badlog.window.graph.plot.MAX_LINES
import badlog.window.graph.plot.OVERVIEW
import badlog.window.graph.plot.drawnLines
import badlog.window.graph.plot.pixelOf
import badlog.window.graph.scene.GraphScene
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import badlog.window.theme.rememberAskedFocus
import badlog.window.video.PlayerFrames

/**
 * The graphs of the open recording, with overview and playback.
 *
 * @param isOpening whether a recording is being read.
 */
@Composable
internal fun GraphPane(scene: GraphScene, modifier: Modifier = Modifier, isOpening: Boolean = false) {
    PlayerFrames(scene.player)
    val open = scene.current.recording
    if (open == null) {
        NothingOpen(isOpening, modifier)
        return
    }
    val focus = rememberAskedFocus(scene.isFocusAsked) { scene.isFocusAsked = false }
    Column(
        modifier.background(LocalPalette.current.surface).takesKeyboard(scene.board::pointerMoved)
            .focusRequester(focus).focusable().semantics { paneTitle = open.label },
    ) {
        GraphToolbar(scene)
        AxisOffer(scene.axis)
        StationOffer(scene.stations)
        Overview(scene)
        Box(
            Modifier.weight(1f).fillMaxWidth().receivesSignals(scene) { names ->
                scene.board.send(GraphChange.Add(names))
            },
        ) {
            when {
                open.signals.isEmpty() -> NothingRecorded(open, Modifier.fillMaxSize())
                scene.board.state.graphs.isEmpty() -> NoGraphs(scene.board, open, Modifier.fillMaxSize())
                else -> GraphColumn(scene)
            }
        }
        FindingStrip(scene)
        XAxisBar(scene)
    }
}

/** Removes the focus from text fields on a press, so that keys are commands again. Calls [onMove] when the pointer moves. */
private fun Modifier.takesKeyboard(onMove: () -> Unit) = composed {
    val focus = LocalFocusManager.current
    pointerInput(focus) {
        awaitPointerEventScope {
            var place = Offset.Unspecified
            while (true) {
                val event = awaitPointerEvent(PointerEventPass.Initial)
                if (event.type == PointerEventType.Press) focus.clearFocus()
                // There are events, too, when something moves below a resting pointer.
                val now = event.changes.first().position
                if (now != place || event.type == PointerEventType.Scroll || event.type == PointerEventType.Press) onMove()
                place = now
            }
        }
    }
}

/** The pane before a recording is open. */
@Composable
internal fun NothingOpen(isOpening: Boolean, modifier: Modifier) {
    if (isOpening) {
        Sentence("Opening the log…", "Its graphs appear in a moment; the line below shows the progress.", modifier.fillMaxSize())
    } else {
        Sentence("No log is open", "Select a log at the left, or drop a file here.", modifier.fillMaxSize())
    }
}

/** The pane if a recording has nothing to draw. */
@Composable
internal fun NothingRecorded(open: OpenRecording, modifier: Modifier) {
    Sentence("There is nothing to draw in this log", "${open.file.fileName} has no topic with a sample.", modifier)
}

/** The pane if a person has removed every graph. */
@Composable
internal fun NoGraphs(board: GraphBoard, open: OpenRecording, modifier: Modifier) {
    Sentence("No graphs", "Drag topics here, or start with the default graphs.", modifier) {
        ToolButton("Show the default graphs", Icons.Graph, text = "Show the default graphs", isOn = true) {
            board.send(BoardAction.ShowAll(open.standardGraphs))
        }
        if (board.canUndo) ToolButton("Show the previous graphs", Icons.Undo, text = "Undo") { board.undo() }
    }
}

@Composable
private fun Sentence(title: String, text: String, modifier: Modifier, action: @Composable () -> Unit = {}) {
    Column(
        modifier.padding(24.dp),
        verticalArrangement = Arrangement.spacedBy(8.dp, Alignment.CenterVertically),
        horizontalAlignment = Alignment.CenterHorizontally,
    ) {
        Text(title, fontSize = 17.sp)
        Text(
            text,
            color = LocalPalette.current.muted,
            textAlign = TextAlign.Center,
            maxLines = 4,
            overflow = TextOverflow.Ellipsis,
        )
        action()
    }
}

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

/** The length of the selection, and actions for it; floats below it, in a pane [width] wide. */
@Composable
internal fun SelectionChip(scene: GraphScene, width: Dp) {
    val selection = scene.view.selection ?: return
    val axis = scene.current.recording?.view?.xAxis ?: return
    val palette = LocalPalette.current
    val right = scene.rightGutter
    Row(
        Modifier
            .layout { measurable, constraints ->
                val chip = measurable.measure(constraints.copy(minWidth = 0, minHeight = 0))
                val height = constraints.maxHeight
                layout(constraints.maxWidth, height) {
                    val plot = (width - GraphScene.LEFT_GUTTER - right).toPx()
                    val center = pixelOf((selection.from + selection.to) / 2, scene.view.viewport.visible, plot)
                    val left = GraphScene.LEFT_GUTTER.toPx() + center - chip.width / 2
                    val most = maxOf(0f, constraints.maxWidth - chip.width - right.toPx())
                    chip.place(left.coerceIn(0f, most).toInt(), height - chip.height - BOTTOM.dp.roundToPx())
                }
            }
            .border(1.dp, palette.accent, RoundedCornerShape(6.dp))
            .background(palette.raised, RoundedCornerShape(6.dp)),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text("Δ ${lengthText(selection.width, axis)}", Modifier.padding(horizontal = 8.dp), fontSize = 12.sp, maxLines = 1)
        ToolButton("Zoom to the selection (Z)", text = "Zoom") { scene.view.send(PlaceAction.ShowSelection) }
        ToolButton("Clear the selection (Escape)", Icons.Close) { scene.view.send(PlaceAction.Select(null)) }
    }
}

private const val BOTTOM = 8

/**
 * Returns the height of each of [graphs], in dp. Lanes have the height they need. A graph with a height of its own keeps it; other graphs
 * of y over x are large. The rest have the height [usual]. With [fit], they share the rest of [room] instead, if each then has at least the
 * minimum height.
 *
 * @param lanes for each graph, its number of lanes; 0 if it has lines of numbers.
 */
internal fun graphHeights(graphs: List<BoardGraph>, lanes: List<Int>, room: Int, usual: Int, fit: Boolean): List<Int> {
    val natural = lanes.mapIndexed { i, count ->
        if (count == 0) {
            graphs[i].height ?: if (graphs[i].isXy) GraphHeight.LARGE.pixels else 0
        } else {
            GraphScene.HEADER_HEIGHT +
                minOf(count, MAX_LINES) * LaneLook.HEIGHT +
                LANES_MARGIN
        }
    }
    val others = natural.count { it == 0 }
    val shared = if (others == 0) 0 else (room - natural.sum()) / others
    val height = if (fit && shared >= BoardGraph.HEIGHTS.first) shared else usual.coerceIn(BoardGraph.HEIGHTS)
    return natural.map { if (it == 0) height else it }
}

private const val LANES_MARGIN = 6
