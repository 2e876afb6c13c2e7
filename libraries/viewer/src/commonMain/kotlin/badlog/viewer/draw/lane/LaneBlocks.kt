package badlog.viewer.draw.lane

import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns
import kotlin.math.ceil
import kotlin.math.floor

/** The blocks of a lane, each in one state, in drawing order. The arrays are reused for the next drawing. */
class LaneBlocks {
    /** The start of each block, in pixels from the frame's left edge, in the first [size] entries. */
    var left: DoubleArray = DoubleArray(0)
        private set

    /** The end of each block, in pixels from the frame's left edge, in the first [size] entries. */
    var right: DoubleArray = DoubleArray(0)
        private set

    /** The state of each block, in the first [size] entries. */
    var states: IntArray = IntArray(0)
        private set

    var size: Int = 0
        private set

    /** The short states, pixel by pixel, so that thousands of them cost no more than the width of the screen. */
    private var slivers = IntArray(0)

    /**
     * Finds the visible blocks of [runs] in [span] on [width] physical pixels; a CSS pixel or dp is [density] of them. Every state is
     * visible: a block shorter than [LaneLook.MIN_BLOCK] is drawn that wide, on top of its longer neighbors. If several compete, the state
     * that is rarest in the recording is shown.
     */
    fun place(runs: StateRuns, span: Span, width: Double, density: Double) {
        val shortest = ceil(LaneLook.MIN_BLOCK * density).toInt()
        size = 0
        val columns = ceil(width).toInt()
        if (slivers.size != columns) slivers = IntArray(columns)
        slivers.fill(NONE)
        for (i in runs.firstReaching(span.from) until runs.states.size) {
            if (runs.to[i] < span.from) continue
            if (runs.from[i] > span.to) {
                if (runs.isOrdered) break else continue
            }
            val from = (runs.from[i] - span.from) / span.width * width
            val to = (runs.to[i] - span.from) / span.width * width
            if (to - from < shortest) {
                addSliver(runs, from, runs.states[i], shortest)
            } else {
                add(from.coerceAtLeast(0.0), to.coerceAtMost(width), runs.states[i])
            }
        }
        addSlivers()
    }

    private fun addSliver(runs: StateRuns, from: Double, state: Int, shortest: Int) {
        val first = floor(from).coerceIn(0.0, maxOf(0, slivers.size - shortest).toDouble()).toInt()
        for (pixel in first until minOf(first + shortest, slivers.size)) {
            val other = slivers[pixel]
            if (other == NONE || runs.timeIn(state) < runs.timeIn(other)) slivers[pixel] = state
        }
    }

    private fun addSlivers() {
        var start = 0
        for (pixel in 1..slivers.size) {
            if (pixel < slivers.size && slivers[pixel] == slivers[start]) continue
            if (slivers[start] != NONE) add(start.toDouble(), pixel.toDouble(), slivers[start])
            start = pixel
        }
    }

    private fun add(from: Double, to: Double, state: Int) {
        if (size == states.size) {
            left = left.copyOf(maxOf(FIRST_BLOCKS, size * 2))
            right = right.copyOf(left.size)
            states = states.copyOf(left.size)
        }
        left[size] = from
        right[size] = to
        states[size++] = state
    }
}

/** The tone of a block of a lane. */
enum class LaneTone {
    /** An almost colorless tone, so that the time when a switch is pressed stands out. */
    OFF,

    /** The state's color, muted enough for a name on top of it. */
    QUIET,

    /** The state's full color: a few pixels of a muted color would be invisible. */
    STRONG,
    ;

    companion object {
        /** Returns the tone of a block in [state], one of [states], that is [width] density-independent pixels wide. */
        fun of(states: List<String>, state: Int, width: Double): LaneTone = when {
            state == 0 && states.size == 2 && states[0] == "false" -> OFF
            width < NARROW -> STRONG
            else -> QUIET
        }

        private const val NARROW = 4.0
    }
}

/** Dimensions of all lanes, in CSS pixels of the page or dp of the window. */
object LaneLook {
    /** The height of a lane, with the space to the next one. */
    const val HEIGHT: Int = 18

    /** The minimum width of a block. */
    const val MIN_BLOCK: Double = 1.5

    /** The font size of a state's name. */
    const val LETTERS: Double = 11.0

    /** The space on either side of a name. */
    const val MARGIN: Double = 5.0

    /**
     * Returns whether [room] pixels are enough for a name, or for its beginning and `…`. Only a few letters would mean nothing, or look
     * like another state's name.
     */
    fun hasRoom(room: Double, isWhole: Boolean): Boolean = room >= if (isWhole) LETTERS else PART

    private const val PART = 40.0
}

private const val NONE = -1
private const val FIRST_BLOCKS = 32
