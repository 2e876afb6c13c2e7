package badlog.viewer.graph

import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import badlog.plot.axis.AxisSide
import badlog.plot.board.Board
import badlog.plot.board.BoardGraph
import badlog.plot.board.GraphHeight
import badlog.plot.path.xyLabelOf
import badlog.viewer.compare.shortLabel
import badlog.viewer.graph.scene.GraphScene
import badlog.viewer.menu.MenuBox
import badlog.viewer.menu.MenuLine
import badlog.viewer.theme.Icons
import badlog.viewer.theme.ToolButton

/** What can be done with a graph: how a menu says it, and whether that is so already. */
internal class GraphAction(val label: String, val isOn: Boolean = false, val run: () -> Unit)

/** What can be done with [spec], in groups. */
internal fun graphActions(scene: GraphScene, spec: BoardGraph): List<List<GraphAction>> {
    val board = scene.board
    return listOf(
        listOfNotNull(
            GraphAction("Keep this graph on the board") { board.keep(spec.id) }.takeIf { board.isEvidence(spec.id) },
            GraphAction("Only this graph") { board.change { Board(listOf(spec)) } },
            GraphAction("Remove this graph") { board.change { without(spec.id) } },
            GraphAction("Remove all graphs") { board.change { Board() } },
        ),
        GraphHeight.entries.map { height ->
            GraphAction("${height.label} height", spec.height == height.pixels) { board.change { resized(spec.id, height.pixels) } }
        } + GraphAction("As high as the others", spec.height == null) { board.change { resized(spec.id, null) } },
        listOf(
            GraphAction("Fix the y limits", spec.yRange != null) { fixY(scene, spec) },
            GraphAction("Share the y limits", spec.sharesY) { board.change { withSharedY(spec.id, !spec.sharesY) } },
        ).takeUnless { spec.isXy }.orEmpty(),
        listOfNotNull(
            GraphAction("Add topics…") { scene.addTopics(spec.id) },
            GraphAction(xyLabelOf(spec.lines, scene.current.recording?.poses.orEmpty()), spec.isXy) {
                board.change { withXy(spec.id, !spec.isXy) }
            }
                .takeIf { spec.lines.size > 1 },
            GraphAction("A graph for each line") { board.change { separated(spec.id) } }.takeIf { spec.lines.size > 1 },
        ),
        board.state.graphs.filter { it.id != spec.id }.map { other ->
            GraphAction("Add to ${quoted(other)}") { board.change { joined(other.id, spec.id) } }
        },
    ).filter { it.isNotEmpty() }
}

/** The title of [graph] as a line of a menu has it. */
internal fun quoted(graph: BoardGraph): String = "“${shortLabel(graph.title, TITLE_LETTERS)}”"

private const val TITLE_LETTERS = 36

/** Keeps what is seen of y in [spec] whatever x is visible, or no longer. */
private fun fixY(scene: GraphScene, spec: BoardGraph) {
    if (spec.yRange != null || spec.rightYRange != null) return scene.board.change { withYRange(spec.id, null) }
    val axes = scene.pictureOf(scene.plots.state(spec.id))?.axes.orEmpty()
    fun shown(side: AxisSide) = axes.find { it.axis.side == side }?.shown
    scene.board.change { withYRange(spec.id, shown(AxisSide.LEFT), shown(AxisSide.RIGHT)) }
}

/** A button that opens what can be done with [spec]; [onOpen] hears whether it is open. */
@Composable
internal fun GraphMenu(scene: GraphScene, spec: BoardGraph, isOpen: Boolean, onOpen: (Boolean) -> Unit) {
    val lines = @Composable {
        graphActions(scene, spec).forEachIndexed { i, group ->
            if (i > 0) HorizontalDivider()
            for (action in group) {
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
