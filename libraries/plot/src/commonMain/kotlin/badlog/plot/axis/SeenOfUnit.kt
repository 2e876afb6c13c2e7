package badlog.plot.axis

/**
 * What is visible of one unit in one graph.
 *
 * @property unit the unit; empty for none.
 * @property least the smallest value; NaN for none.
 * @property most the largest value; NaN for none.
 */
public data class SeenOfUnit(public val unit: String, public val least: Double, public val most: Double)

/** Returns what is visible of each unit in all graphs that share their limits; [seen] has an entry for each of their axes. */
public fun seenTogether(seen: List<SeenOfUnit>): Map<String, SeenOfUnit> {
    val together = HashMap<String, SeenOfUnit>()
    for (one in seen) {
        if (one.least.isNaN()) continue
        val other = together[one.unit] ?: one
        together[one.unit] = SeenOfUnit(one.unit, minOf(one.least, other.least), maxOf(one.most, other.most))
    }
    return together
}
