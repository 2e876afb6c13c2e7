package badlog.viewer.graph

import badlog.plot.board.BoardGraph
import badlog.plot.board.GraphHeight
import badlog.plot.lane.LaneLook
import badlog.viewer.graph.plot.MAX_LINES
import badlog.viewer.graph.scene.GraphScene

/**
 * How tall each of [graphs] is, in dp. Lanes have the height they need, and who has a height of its own has that. Other graphs of
 * y over x are large, those of numbers are [usual] tall, or share what is left of [room] when they [fit] into it with no less than the least height each.
 *
 * @param lanes for each graph how many lanes it is made of, 0 when it has lines of numbers.
 */
internal fun graphHeights(graphs: List<BoardGraph>, lanes: List<Int>, room: Int, usual: Int, fit: Boolean): List<Int> {
    val natural = lanes.mapIndexed { i, count ->
        if (count ==
            0
        ) {
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
