package badlog.window.graph

import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.FieldOrigin
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.board.canSwapAxes
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.path.xyLabelOf
import badlog.viewer.shown.comparison.shortLabel
import badlog.viewer.shown.search.Query
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.xy.xyPictureOf
import badlog.window.log.GraphBoard
import badlog.window.menu.MenuBox
import badlog.window.menu.MenuLine
import badlog.window.theme.Icons
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton

/** An action for a graph: its label in a menu, and whether it is on. */
internal class GraphAction(val label: String, val isOn: Boolean = false, val run: () -> Unit)

/** Returns the actions for [spec], in groups; the last group adds it to another graph. */
internal fun graphActions(scene: GraphScene, spec: BoardGraph): List<List<GraphAction>> {
    val board = scene.board
    return listOf(
        listOfNotNull(
            GraphAction("Keep this graph on the board") { board.keep(spec.id) }.takeIf { board.isEvidence(spec.id) },
            GraphAction("Move to the top") {
                board.change { moved(spec.id, -graphs.size) }
            }.takeIf { board.state.graphs.indexOf(spec) > 0 },
            GraphAction("Only this graph") { board.change { Board(listOf(spec)) } },
            GraphAction("Remove this graph") { board.change { without(spec.id) } },
            GraphAction("Remove all graphs") { board.change { Board() } },
        ),
        GraphHeight.entries.map { height ->
            GraphAction("Height: ${height.label.lowercase()}", spec.height == height.pixels) {
                board.change { resized(spec.id, height.pixels) }
            }
        } + GraphAction("Height: as the others", spec.height == null) { board.change { resized(spec.id, null) } },
        listOf(
            GraphAction("Fix the y limits", spec.yRange != null) { fixY(scene, spec) },
            GraphAction("Share the y limits", spec.sharesY) { board.change { withSharedY(spec.id, !spec.sharesY) } },
        ).takeUnless { spec.isXy }.orEmpty(),
        listOfNotNull(
            GraphAction("Add topics…") { scene.addTopics(spec.id) },
            GraphAction(xyLabelOf(spec.lines, scene.current.recording?.paths?.poses.orEmpty()), spec.isXy) {
                board.change { withXy(spec.id, !spec.isXy) }
            }
                .takeIf { spec.lines.size > 1 },
            GraphAction("Swap axes") { board.change { withSwappedAxes(spec.id) } }
                .takeIf { spec.canSwapAxes(scene.current.recording?.paths?.poses.orEmpty()) },
            GraphAction("A graph for each line") { board.change { separated(spec.id) } }.takeIf { spec.lines.size > 1 },
        ),
        if (spec.isXy && xyPictureOf(spec, scene.recordings).isField) fieldActions(scene, spec) else emptyList(),
        additionsOf(board, spec),
    ).filter { it.isNotEmpty() }
}

private fun fieldActions(scene: GraphScene, spec: BoardGraph) = FieldOrigin.entries.map { origin ->
    GraphAction(origin.label, spec.origin == origin) { scene.board.change { withOrigin(spec.id, origin) } }
} + listOfNotNull(
    GraphAction("Select a field file…", scene.fields.isSelected, scene.fields::askForField),
    GraphAction("Deselect the field file", run = scene.fields::deselect).takeIf { scene.fields.isSelected },
)

private fun additionsOf(board: GraphBoard, spec: BoardGraph) = board.state.graphs.filter { it.id != spec.id }.map { other ->
    GraphAction("Add to ${quoted(board, other)}") { board.change { joined(other.id, spec.id) } }
}

/** Returns the title of [graph], one of those of [board], for a menu. */
internal fun quoted(board: GraphBoard, graph: BoardGraph): String = "“${shortLabel(board.titleOf(graph), TITLE_LETTERS)}”"

private const val TITLE_LETTERS = 36

/** Fixes or unfixes the visible y range of [spec]. */
private fun fixY(scene: GraphScene, spec: BoardGraph) {
    if (spec.yRange != null || spec.rightYRange != null) return scene.board.change { withYRange(spec.id, null) }
    val axes = scene.pictureOf(scene.plots.state(spec.id))?.plot?.axes.orEmpty()
    fun shown(side: AxisSide) = axes.find { it.side == side }?.shown
    scene.board.change { withYRange(spec.id, shown(AxisSide.LEFT), shown(AxisSide.RIGHT)) }
}

/** A button that opens the menu of [spec]; [onOpen] is called with whether it is open. */
@Composable
internal fun GraphMenu(scene: GraphScene, spec: BoardGraph, isOpen: Boolean, onOpen: (Boolean) -> Unit) {
    var search by remember(isOpen) { mutableStateOf("") }
    val lines = @Composable {
        val groups = graphActions(scene, spec)
        val isLong = groups.last().size > FEW
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
private const val FEW = 8
private val SEARCH_WIDTH = 280.dp
