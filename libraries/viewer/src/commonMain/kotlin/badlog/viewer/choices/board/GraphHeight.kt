package badlog.viewer.choices.board

import kotlin.math.abs

/**
 * The named heights of a graph of numbers. A board stores pixels, which older programs can read, too; see
 * [BoardGraph.height].
 *
 * @property label its name in a menu.
 * @property pixels the height in density-independent pixels.
 */
enum class GraphHeight(val label: String, val pixels: Int) {
    /** Four of them fit on the first screen, even of a phone, which a finding's graphs need; each still has room for four numbers on y. */
    SMALL("Small", 104),

    /** The default. */
    MEDIUM("Medium", 190),

    /** For a close look. */
    LARGE("Large", 380),
    ;

    /** The next height; after the last one, the first. */
    val next: GraphHeight get() = entries[(ordinal + 1) % entries.size]

    companion object {
        /** Returns the one nearest to a [height] in pixels; [MEDIUM] for null. */
        fun of(height: Int?): GraphHeight = if (height == null) MEDIUM else entries.minBy { abs(it.pixels - height) }
    }
}
