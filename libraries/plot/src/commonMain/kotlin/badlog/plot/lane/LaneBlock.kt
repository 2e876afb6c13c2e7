package badlog.plot.lane

import badlog.analysis.Span
import badlog.analysis.StateRuns
import kotlin.math.ceil
import kotlin.math.floor

/**
 * A part of a lane in one state, in pixels from the frame's left edge.
 *
 * @property left where it begins.
 * @property right where it ends.
 * @property state which state it is.
 */
public data class LaneBlock(public val left: Double, public val right: Double, public val state: Int) {
    /** How wide it is. */
    public val width: Double get() = right - left
}

/**
 * What of [runs] is to be seen of [span] on [width] pixels, in the order in which it is to be drawn. No state is lost:
 * one that lasts shorter than [shortest] pixels gets that many, over the longer ones beside it; where several do, the
 * one in which the recording is the least of its time is seen.
 */
public fun laneBlocks(runs: StateRuns, span: Span, width: Double, shortest: Int): List<LaneBlock> {
    val blocks = ArrayList<LaneBlock>()
    val slivers = Slivers(runs, ceil(width).toInt(), shortest)
    fun pixelOf(x: Double) = (x - span.from) / span.width * width
    for (i in runs.firstReaching(span.from) until runs.states.size) {
        if (runs.to[i] < span.from) continue
        if (runs.from[i] > span.to) {
            if (runs.isOrdered) break else continue
        }
        val left = pixelOf(runs.from[i])
        val right = pixelOf(runs.to[i])
        if (right - left < shortest) {
            slivers.add(left, runs.states[i])
        } else {
            blocks += LaneBlock(left.coerceAtLeast(0.0), right.coerceAtMost(width), runs.states[i])
        }
    }
    return blocks + slivers.blocks()
}

/** The short states of a lane, pixel by pixel: thousands of them cost no more than the screen is wide. */
private class Slivers(private val runs: StateRuns, count: Int, private val shortest: Int) {
    private val states = IntArray(count) { NONE }

    fun add(left: Double, state: Int) {
        val first = floor(left).coerceIn(0.0, maxOf(0, states.size - shortest).toDouble()).toInt()
        for (pixel in first until minOf(first + shortest, states.size)) {
            val other = states[pixel]
            if (other == NONE || runs.timeIn(state) < runs.timeIn(other)) states[pixel] = state
        }
    }

    fun blocks(): List<LaneBlock> {
        val blocks = ArrayList<LaneBlock>()
        var start = 0
        for (pixel in 1..states.size) {
            if (pixel < states.size && states[pixel] == states[start]) continue
            if (states[start] != NONE) blocks += LaneBlock(start.toDouble(), pixel.toDouble(), states[start])
            start = pixel
        }
        return blocks
    }

    private companion object {
        const val NONE = -1
    }
}
