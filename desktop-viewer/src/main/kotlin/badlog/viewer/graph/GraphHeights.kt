package badlog.viewer.graph

import badlog.viewer.graph.plot.LANE_HEIGHT
import badlog.viewer.graph.plot.MOST_LINES

/**
 * How high each graph is, in dp. Lanes have the height they need. Graphs of numbers are [chosen] high, or share what is left of
 * [room] when they [fit] into it with no less than the least of [HEIGHTS] each.
 *
 * @param lanes for each graph how many lanes it is made of, 0 when it has lines of numbers.
 */
internal fun graphHeights(lanes: List<Int>, room: Int, chosen: Int, fit: Boolean): List<Int> {
    val natural = lanes.map { if (it == 0) 0 else HEADER_HEIGHT + minOf(it, MOST_LINES) * LANE_HEIGHT + LANES_MARGIN }
    val others = lanes.count { it == 0 }
    val shared = if (others == 0) 0 else (room - natural.sum()) / others
    val height = if (fit && shared >= HEIGHTS.first) shared else chosen.coerceIn(HEIGHTS)
    return natural.map { if (it == 0) height else it }
}

/** How high a graph of numbers can be, in dp. */
internal val HEIGHTS = 60..600

/** How high the line above a graph is, in dp. */
internal const val HEADER_HEIGHT = 22

private const val LANES_MARGIN = 6
