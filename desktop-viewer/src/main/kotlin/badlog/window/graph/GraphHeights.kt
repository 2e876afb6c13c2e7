package badlog.window.graph

import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.draw.lane.LaneLook
import badlog.window.graph.plot.MAX_LINES
import badlog.window.graph.scene.GraphScene

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
