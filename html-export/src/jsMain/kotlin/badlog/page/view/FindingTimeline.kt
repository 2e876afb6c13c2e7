package badlog.page.view

import badlog.recording.Severity

/** The findings of a recording by their places on the x axis. */
internal class FindingTimeline(all: List<Finding>) {
    /** The worst first, and of one severity in the order of x; those about the whole come before those with a place. */
    val worstFirst: List<Finding> =
        all.sortedWith(compareBy<Finding> { -it.severity.ordinal }.thenBy { if (it.isPlaced) it.time else Double.NEGATIVE_INFINITY })

    /** Those with a place, in the order of x. */
    val placed: List<Finding> = all.filter { it.isPlaced }.sortedBy { it.time }

    /** How many are of [severity]. */
    fun count(severity: Severity): Int = worstFirst.count { it.severity == severity }

    /** Those that are no further than [distance] from [x], or last over it, the worst first. */
    fun at(x: Double, distance: Double): List<Finding> =
        if (placed.isEmpty()) placed else worstFirst.filter { x >= it.time - distance && x <= it.end + distance }

    /**
     * The one [steps] after [current] while the cursor at [x] still is at that, else the first after x; before them when [steps]
     * is negative. Null beyond the last one.
     */
    fun beside(current: Finding?, x: Double, steps: Int): Finding? {
        val index = if (current?.time == x) placed.indexOf(current) else -1
        return when {
            index >= 0 -> placed.getOrNull(index + steps)
            steps > 0 -> if (x.isNaN()) placed.firstOrNull() else placed.firstOrNull { it.time > x }
            else -> if (x.isNaN()) placed.lastOrNull() else placed.lastOrNull { it.time < x }
        }
    }
}
