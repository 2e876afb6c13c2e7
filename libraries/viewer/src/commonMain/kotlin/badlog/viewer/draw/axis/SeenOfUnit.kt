package badlog.viewer.draw.axis

import badlog.viewer.draw.curve.Strokes

/**
 * What is visible of one unit in one graph.
 *
 * @property unit the unit; empty for none.
 * @property least the smallest value; NaN for none.
 * @property most the largest value; NaN for none.
 */
data class SeenOfUnit(val unit: String, val least: Double, val most: Double)

/** Returns what is visible on each of [axes] of lines with these [strokes]. */
fun seenOn(axes: List<GraphAxis>, strokes: List<Strokes>): List<SeenOfUnit> = axes.map { axis ->
    val seen = axis.lines.map(strokes::get).filter { !it.min.isNaN() }
    SeenOfUnit(axis.unit, seen.minOfOrNull { it.min } ?: Double.NaN, seen.maxOfOrNull { it.max } ?: Double.NaN)
}

/** Returns what is visible of each unit in all graphs that share their limits; [seen] has an entry for each of their axes. */
fun seenTogether(seen: List<SeenOfUnit>): Map<String, SeenOfUnit> {
    val together = HashMap<String, SeenOfUnit>()
    for (one in seen) {
        if (one.least.isNaN()) continue
        val other = together[one.unit] ?: one
        together[one.unit] = SeenOfUnit(one.unit, minOf(one.least, other.least), maxOf(one.most, other.most))
    }
    return together
}
