package badlog.plot.board

import kotlin.math.abs

/**
 * How high a graph of numbers is, in words. A board keeps pixels, which older programs read too, see [BoardGraph.height].
 *
 * @property label what a menu calls it.
 * @property pixels how high it looks.
 */
public enum class GraphHeight(public val label: String, public val pixels: Int) {
    /** Four fit the first screen, also of a phone, as those that show a finding do; four numbers of y still fit each. */
    SMALL("Small", 104),

    /** As high as graphs are without a choice. */
    MEDIUM("Medium", 190),

    /** One to look at closely. */
    LARGE("Large", 380),
    ;

    /** The one after it; the first one after the last. */
    public val next: GraphHeight get() = entries[(ordinal + 1) % entries.size]

    public companion object {
        /** The one nearest to a [height] in pixels; [MEDIUM] for null. */
        public fun of(height: Int?): GraphHeight = if (height == null) MEDIUM else entries.minBy { abs(it.pixels - height) }
    }
}
