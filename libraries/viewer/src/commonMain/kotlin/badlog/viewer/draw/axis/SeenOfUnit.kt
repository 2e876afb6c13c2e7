package badlog.viewer.draw.axis

import badlog.viewer.draw.curve.Strokes

/**
 * The visible range of one unit in one graph.
 *
 * @property unit the unit; empty if there is none.
 * @property least the smallest value; NaN if there is none.
 * @property most the largest value; NaN if there is none.
 */
data class SeenOfUnit(val unit: String, val least: Double, val most: Double)

/** Returns the visible range on each of [axes], for lines with these [strokes]. */
fun seenOn(axes: List<GraphAxis>, strokes: List<Strokes>): List<SeenOfUnit> = axes.map { axis ->
    val seen = axis.lines.map(strokes::get).filter { !it.min.isNaN() }
    SeenOfUnit(axis.unit, seen.minOfOrNull { it.min } ?: Double.NaN, seen.maxOfOrNull { it.max } ?: Double.NaN)
}

/** Returns the visible range of each unit in all graphs that share their limits. [seen] has an entry for each of their axes. */
fun seenTogether(seen: List<SeenOfUnit>): Map<String, SeenOfUnit> {
    val together = HashMap<String, SeenOfUnit>()
    for (one in seen) {
        if (one.least.isNaN()) continue
        val other = together[one.unit] ?: one
        together[one.unit] = SeenOfUnit(one.unit, minOf(one.least, other.least), maxOf(one.most, other.most))
    }
    return together
}
