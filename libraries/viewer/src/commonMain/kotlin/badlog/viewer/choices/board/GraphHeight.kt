package badlog.viewer.choices.board

import kotlin.math.abs

/**
 * The named heights of a graph of numbers. A board stores pixels, which older programs can read, too; see [BoardGraph.height].
 *
 * @property label the name in a menu.
 * @property pixels the height in density-independent pixels.
 */
enum class GraphHeight(val label: String, val pixels: Int) {
    /**
     * The height of a finding's graphs. Four of them fit on the first screen, even of a phone; each still has room for four numbers on y.
     */
    SMALL("Small", 104),

    /** The default. */
    MEDIUM("Medium", 190),

    /** The height for a close look. */
    LARGE("Large", 380),
    ;

    /** The next height; after the last one, the first. */
    val next: GraphHeight get() = entries[(ordinal + 1) % entries.size]

    companion object {
        /** Returns the named height nearest to a [height] in pixels; [MEDIUM] if it is null. */
        fun of(height: Int?): GraphHeight = if (height == null) MEDIUM else entries.minBy { abs(it.pixels - height) }
    }
}
