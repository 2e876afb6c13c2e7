package badlog.window.graph

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.input.KeyAction
import badlog.viewer.session.GraphOffer
import badlog.viewer.session.GraphOffers
import badlog.viewer.shown.comparison.shortLabel
import badlog.viewer.shown.search.Query
import badlog.viewer.state.GraphChange
import badlog.window.graph.scene.GraphScene
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.LiveView
import badlog.window.menu.MenuBox
import badlog.window.menu.MenuLine
import badlog.window.settings.SettingsStore
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton
import badlog.window.video.PlaybackButtons

/** The toolbar of the graphs: visible range, playback, and height. In a wide one, each icon has a word beside it. */
@Composable
internal fun GraphToolbar(scene: GraphScene) {
    BoxWithConstraints(Modifier.fillMaxWidth().background(LocalPalette.current.surface)) {
        val hasLabels = maxWidth >= LABELED
        FlowRow(
            Modifier.padding(horizontal = 8.dp, vertical = 2.dp),
            horizontalArrangement = Arrangement.spacedBy(12.dp),
            itemVerticalAlignment = Alignment.CenterVertically,
        ) {
            ViewButtons(scene.current, scene.view, hasLabels)
            LiveButton(scene.live)
            PlaybackButtons(scene.player, isEnabled = scene.current.recording != null, hasLabels)
            HeightButtons(scene.settings, hasLabels)
            BoardButtons(scene.board, hasLabels)
        }
    }
}

@Composable
private fun ViewButtons(current: CurrentRecording, view: AxisView, hasLabels: Boolean) {
    // The view changes with every turn of the wheel, but the buttons hardly ever.
    val isZoomed by remember(view) { derivedStateOf { view.viewport.isZoomed } }
    val hasHistory by remember(view) { derivedStateOf { view.viewport.canGoBack } }
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("Show everything (0)", text = "All", isEnabled = isZoomed) { view.press(KeyAction.SHOW_ALL) }
        ToolButton("Previous view (Backspace)", Icons.Back, "Previous".takeIf { hasLabels }, isEnabled = hasHistory) {
            view.press(KeyAction.PREVIOUS_VIEW)
        }
        ToolButton("Zoom out (-)", Icons.Remove, "Zoom out".takeIf { hasLabels }, isEnabled = isZoomed) {
            view.press(KeyAction.ZOOM_OUT)
        }
        ToolButton("Zoom in (+)", Icons.Add, "Zoom in".takeIf { hasLabels }) { view.press(KeyAction.ZOOM_IN) }
        if (current.recording?.enabled.orEmpty().isNotEmpty()) {
            ToolButton("Zoom to the time the robot was enabled (E)", text = "Enabled") {
                view.press(KeyAction.SHOW_ENABLED)
            }
        }
    }
}

/** The button to follow a log that is being written; empty for other logs. */
@Composable
private fun LiveButton(live: LiveView) {
    if (!live.isGrowing) return
    val isOn = live.isStaying
    val meaning = if (isOn) "Stay here while the log grows" else "Follow the log while it is written (End)"
    ToolButton(meaning, text = "Live", isOn = isOn) { if (isOn) live.pause() else live.begin() }
}

@Composable
private fun BoardButtons(board: GraphBoard, hasLabels: Boolean) {
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("Undo (${KeyAction.UNDO.shortcut})", Icons.Undo, "Undo".takeIf { hasLabels }, isEnabled = board.canUndo) { board.undo() }
        ToolButton("Redo (${KeyAction.REDO.shortcut})", Icons.Redo, "Redo".takeIf { hasLabels }, isEnabled = board.canRedo) { board.redo() }
        ToolButton("Remove all graphs", text = "Remove all", isEnabled = board.state.graphs.isNotEmpty()) {
            board.send(GraphChange.ShowOnly(emptyList()))
        }
    }
}

@Composable
private fun HeightButtons(settings: SettingsStore, hasLabels: Boolean) {
    val state = settings.state
    val isShortest = state.graphHeight <= BoardGraph.HEIGHTS.first
    val isTallest = state.graphHeight >= BoardGraph.HEIGHTS.last
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("Shorter graphs (Ctrl+Shift+wheel)", Icons.Shrink, "Shorter".takeIf { hasLabels }, isEnabled = !isShortest) {
            setGraphHeight(settings, state.graphHeight - HEIGHT_STEP)
        }
        ToolButton("Taller graphs (Ctrl+Shift+wheel)", Icons.Grow, "Taller".takeIf { hasLabels }, isEnabled = !isTallest) {
            setGraphHeight(settings, state.graphHeight + HEIGHT_STEP)
        }
        ToolButton("Share the window's height among few graphs", text = "Fit", isOn = state.fitsGraphs) {
            settings.change { copy(fitsGraphs = !fitsGraphs) }
        }
    }
}

/** Makes graphs [height] dp high, within their limits; they no longer share the window's height. */
internal fun setGraphHeight(settings: SettingsStore, height: Int) {
    settings.change { copy(graphHeight = height.coerceIn(BoardGraph.HEIGHTS), fitsGraphs = false) }
}

/** From this width, the toolbar has room for all words in a single line. */
private val LABELED = 1020.dp

private const val HEIGHT_STEP = 25

/** An action for a graph: its label in a menu, and whether it is on. */
internal class GraphAction(val label: String, val isOn: Boolean = false, val run: () -> Unit)

/** Returns the actions for [spec], in groups; the last group adds it to another graph. */
internal fun graphActions(scene: GraphScene, spec: BoardGraph): List<List<GraphAction>> {
    val board = scene.board
    val offers = GraphOffers(board.state, spec, scene.current.recording?.paths?.poses.orEmpty())
    fun List<GraphOffer>.actions() = map { GraphAction(it.label, it.isOn == true) { board.send(it.change) } }
    return listOf(
        listOfNotNull(GraphAction("Keep this graph on the board") { board.keep(spec.id) }.takeIf { board.isEvidence(spec.id) }) +
            offers.moves.actions() +
            GraphAction("Only this graph") { board.send(GraphChange.ShowOnly(listOf(spec))) } +
            listOf(offers.removal).actions() +
            GraphAction("Remove all graphs") { board.send(GraphChange.ShowOnly(emptyList())) },
        offers.heights(usual = null).actions() +
            GraphAction("Height: as the others", spec.height == null) { board.send(GraphChange.Resize(spec.id, null)) },
        offers.limits(shownY(scene, spec)).actions(),
        listOf(GraphAction("Add topics…") { scene.addTopics(spec.id) }) + (offers.planes + listOfNotNull(offers.separation)).actions(),
        offers.origins.actions().let { if (it.isEmpty()) it else it + fieldActions(scene) },
        offers.additions(board.state.graphs.map { shortTitle(board, it) }).actions(),
    ).filter { it.isNotEmpty() }
}

private fun fieldActions(scene: GraphScene) = listOfNotNull(
    GraphAction("Select a field file…", scene.fields.isSelected, scene.fields::askForField),
    GraphAction("Deselect the field file", run = scene.fields::deselect).takeIf { scene.fields.isSelected },
)

/** Returns the ranges of y that [spec] shows now, the range of the left axis first. */
private fun shownY(scene: GraphScene, spec: BoardGraph) = scene.pictureOf(scene.plots.state(spec.id))?.plot?.axes.orEmpty().map { it.shown }

/** Returns the quoted title of [graph], which is on [board], for a menu. */
internal fun quoted(board: GraphBoard, graph: BoardGraph): String = "“${shortTitle(board, graph)}”"

private fun shortTitle(board: GraphBoard, graph: BoardGraph) = shortLabel(board.titleOf(graph), TITLE_LETTERS)

private const val TITLE_LETTERS = 36

/** A button that opens the menu of [spec]; [onOpen] receives whether it is open. */
@Composable
internal fun GraphMenu(scene: GraphScene, spec: BoardGraph, isOpen: Boolean, onOpen: (Boolean) -> Unit) {
    var search by remember(isOpen) { mutableStateOf("") }
    val lines = @Composable {
        val groups = graphActions(scene, spec)
        val isLong = groups.last().size > MAX_WITHOUT_SEARCH
        val query = Query(search)
        groups.forEachIndexed { i, group ->
            if (i > 0) HorizontalDivider()
            val isSearched = isLong && i == groups.lastIndex
            if (isSearched) {
                SearchField(
                    search,
                    "Search graphs to add it to",
                    Modifier.padding(horizontal = 12.dp, vertical = 4.dp).width(SEARCH_WIDTH),
                ) {
                    search =
                        it
                }
            }
            for (action in group.filter { !isSearched || query.matches(it.label) }) {
                MenuLine(action.label, Icons.Check.takeIf { action.isOn }) {
                    onOpen(false)
                    action.run()
                }
            }
        }
    }
    MenuBox(isOpen, { onOpen(false) }, menu = lines) {
        ToolButton("More for this graph", Icons.More, isOn = isOpen) { onOpen(!isOpen) }
    }
}

/** Up to this many lines are easy to find without a search. */
private const val MAX_WITHOUT_SEARCH = 8
private val SEARCH_WIDTH = 280.dp
