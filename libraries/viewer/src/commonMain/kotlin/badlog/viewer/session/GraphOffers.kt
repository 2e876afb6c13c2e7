package badlog.viewer.session

import badlog.core.analysis.Span
import badlog.signals.pose.Pose
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.FieldOrigin
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.board.canSwapAxes
import badlog.viewer.draw.path.xyLabelOf
import badlog.viewer.state.GraphChange

/**
 * A command in the menu of a graph.
 *
 * @property label the text in the menu.
 * @property isOn whether the setting is in effect; null for a command that is done once.
 * @property change the effect of the command.
 */
class GraphOffer(val label: String, val isOn: Boolean? = null, val change: GraphChange)

/** The commands in the menu of [graph], which is on [board]; the log has [poses]. Each front end arranges them in its own menu. */
class GraphOffers(private val board: Board, private val graph: BoardGraph, private val poses: List<Pose>) {
    private val id = graph.id

    /** The moves to other places on the board; a place where the graph already is has no command. */
    val moves: List<GraphOffer>
        get() {
            val place = board.graphs.indexOfFirst { it.id == id }
            return listOfNotNull(
                GraphOffer("Move to the top", change = GraphChange.Move(id, -place)).takeIf { place > 1 },
                GraphOffer("Move up", change = GraphChange.Move(id, -1)).takeIf { place > 0 },
                GraphOffer("Move down", change = GraphChange.Move(id, 1)).takeIf { place < board.graphs.lastIndex },
            )
        }

    /**
     * Returns the commands for the named heights. For a graph without a height of its own, the [usual] one is in effect, or none if that is
     * null.
     */
    fun heights(usual: GraphHeight?): List<GraphOffer> {
        val now = graph.height?.let { GraphHeight.of(it) } ?: usual
        return GraphHeight.entries.map { height ->
            GraphOffer("Height: ${height.label.lowercase()}", height == now, GraphChange.Resize(id, height.pixels))
        }
    }

    /** The ways to draw the graph's lines over each other; empty for a single line. */
    val planes: List<GraphOffer>
        get() = listOfNotNull(
            GraphOffer(xyLabelOf(graph.lines, poses), graph.isXy, GraphChange.DrawXy(id, !graph.isXy)).takeIf { graph.lines.size > 1 },
            GraphOffer("Swap axes", change = GraphChange.SwapAxes(id)).takeIf { graph.canSwapAxes(poses) },
        )

    /** The origins of the graph's poses; empty if it does not draw a path. */
    val origins: List<GraphOffer>
        get() = if (graph.isXy && poses.any { it.x in graph.lines && it.y in graph.lines }) {
            FieldOrigin.entries.map { origin -> GraphOffer(origin.label, graph.origin == origin, GraphChange.MeasureFrom(id, origin)) }
        } else {
            emptyList()
        }

    /** Returns the commands for the y limits; none for a plane. [shown] has the current limits, the left axis first. */
    fun limits(shown: List<Span>): List<GraphOffer> = if (graph.isXy) {
        emptyList()
    } else {
        val fixed = if (graph.isYFixed) emptyList() else shown
        listOf(
            GraphOffer("Fix the y limits", graph.isYFixed, GraphChange.ShowY(id, fixed.getOrNull(0), fixed.getOrNull(1))),
            GraphOffer("Share the y limits", graph.sharesY, GraphChange.ShareY(id, !graph.sharesY)),
        )
    }

    /** The command that splits the graph into one for each line; null for a single line. */
    val separation: GraphOffer?
        get() = GraphOffer("A graph for each line", change = GraphChange.Separate(id)).takeIf { graph.lines.size > 1 }

    /**
     * Returns a command for each other graph to which this graph's lines can be added. [titles] has the titles of all graphs of the board,
     * in order.
     */
    fun additions(titles: List<String>): List<GraphOffer> = board.graphs.zip(titles).filter { (other, _) -> other.id != id }
        .map { (other, title) -> GraphOffer("Add to “$title”", change = GraphChange.Join(other.id, id)) }

    /** The command that removes the graph from the board. */
    val removal: GraphOffer get() = GraphOffer("Remove this graph", change = GraphChange.Remove(id))
}
