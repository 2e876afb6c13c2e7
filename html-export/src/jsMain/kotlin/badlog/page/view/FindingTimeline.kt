package badlog.page.view

import badlog.recording.Severity

/** The findings of a recording by their places on the x axis. */
internal class FindingTimeline(all: List<Finding>) {
    /** The worst first, and of one severity in the order of x; those about the whole come before those with a place. */
    val worstFirst: List<Finding> =
        all.sortedWith(compareBy<Finding> { -it.severity.ordinal }.thenBy { if (it.isPlaced) it.time else Double.NEGATIVE_INFINITY })

    /** All places of all of them, in the order of x. */
    val places: List<FindingPlace> = all.flatMap { it.places }.sortedBy { it.span.from }

    /** How many are of [severity]. */
    fun count(severity: Severity): Int = worstFirst.count { it.severity == severity }

    /** Those that are no further than [distance] from [x], or last over it, the worst first. */
    fun at(x: Double, distance: Double): List<Finding> =
        worstFirst.filter { finding -> finding.places.any { x >= it.span.from - distance && x <= it.span.to + distance } }

    /**
     * The place [steps] after [current] while the cursor at [x] still is at that, else the first after x; before them when [steps]
     * is negative. Null beyond the last one.
     */
    fun beside(current: FindingPlace?, x: Double, steps: Int): FindingPlace? {
        val index = if (current?.span?.from == x) places.indexOf(current) else -1
        return when {
            index >= 0 -> places.getOrNull(index + steps)
            steps > 0 -> if (x.isNaN()) places.firstOrNull() else places.firstOrNull { it.span.from > x }
            else -> if (x.isNaN()) places.lastOrNull() else places.lastOrNull { it.span.from < x }
        }
    }
}
