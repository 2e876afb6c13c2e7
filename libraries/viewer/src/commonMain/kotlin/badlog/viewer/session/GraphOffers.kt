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
 * Something that the menu of a graph offers.
 *
 * @property label what the menu says.
 * @property isOn whether it is in effect; null if it is done once.
 * @property change what it does.
 */
class GraphOffer(val label: String, val isOn: Boolean? = null, val change: GraphChange)

/** What the menu of [graph] offers, one of those of [board]; the log has [poses]. Each front end arranges it in its own menu. */
class GraphOffers(private val board: Board, private val graph: BoardGraph, private val poses: List<Pose>) {
    private val id = graph.id

    /** The other places on the board, as far as it is not there. */
    val moves: List<GraphOffer>
        get() {
            val place = board.graphs.indexOfFirst { it.id == id }
            return listOfNotNull(
                GraphOffer("Move to the top", change = GraphChange.Move(id, -place)).takeIf { place > 1 },
                GraphOffer("Move up", change = GraphChange.Move(id, -1)).takeIf { place > 0 },
                GraphOffer("Move down", change = GraphChange.Move(id, 1)).takeIf { place < board.graphs.lastIndex },
            )
        }

    /** The named heights; of a graph without a height of its own, the [usual] one is in effect, null for none. */
    fun heights(usual: GraphHeight?): List<GraphOffer> {
        val now = graph.height?.let { GraphHeight.of(it) } ?: usual
        return GraphHeight.entries.map { height ->
            GraphOffer("Height: ${height.label.lowercase()}", height == now, GraphChange.Resize(id, height.pixels))
        }
    }

    /** How its lines can be drawn over each other; nothing for a single line. */
    val planes: List<GraphOffer>
        get() = listOfNotNull(
            GraphOffer(xyLabelOf(graph.lines, poses), graph.isXy, GraphChange.DrawXy(id, !graph.isXy)).takeIf { graph.lines.size > 1 },
            GraphOffer("Swap axes", change = GraphChange.SwapAxes(id)).takeIf { graph.canSwapAxes(poses) },
        )

    /** The origins of its poses; nothing if it draws no path. */
    val origins: List<GraphOffer>
        get() = if (graph.isXy && poses.any { it.x in graph.lines && it.y in graph.lines }) {
            FieldOrigin.entries.map { origin -> GraphOffer(origin.label, graph.origin == origin, GraphChange.MeasureFrom(id, origin)) }
        } else {
            emptyList()
        }

    /** What can be done with its y limits, of which it has [shown] now, those of the left axis first; nothing for a plane. */
    fun limits(shown: List<Span>): List<GraphOffer> = if (graph.isXy) {
        emptyList()
    } else {
        val fixed = if (graph.isYFixed) emptyList() else shown
        listOf(
            GraphOffer("Fix the y limits", graph.isYFixed, GraphChange.ShowY(id, fixed.getOrNull(0), fixed.getOrNull(1))),
            GraphOffer("Share the y limits", graph.sharesY, GraphChange.ShareY(id, !graph.sharesY)),
        )
    }

    /** A graph for each of its lines; null for a single line. */
    val separation: GraphOffer?
        get() = GraphOffer("A graph for each line", change = GraphChange.Separate(id)).takeIf { graph.lines.size > 1 }

    /** The other graphs that can have its lines, too; [titles] are those of all graphs of the board. */
    fun additions(titles: List<String>): List<GraphOffer> = board.graphs.zip(titles).filter { (other, _) -> other.id != id }
        .map { (other, title) -> GraphOffer("Add to “$title”", change = GraphChange.Join(other.id, id)) }

    /** Takes it off the board. */
    val removal: GraphOffer get() = GraphOffer("Remove this graph", change = GraphChange.Remove(id))
}
