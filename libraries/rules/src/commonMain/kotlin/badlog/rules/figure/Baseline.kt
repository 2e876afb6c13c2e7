package badlog.rules.figure

import kotlin.math.abs

/**
 * What the same figure is in the team's other logs: a median, and how far logs usually are from it (1.4826 times the median
 * absolute deviation, which is the standard deviation of what is distributed normally). A single odd log changes neither.
 *
 * @property second how far the second farthest of the others is from the median.
 */
internal class Baseline(private val others: DoubleArray) {
    val median: Double
    val distance: Double
    val second: Double

    init {
        others.sort()
        median = middleOf(others)
        val distances = DoubleArray(others.size) { abs(others[it] - median) }.apply { sort() }
        distance = NORMAL * middleOf(distances)
        second = distances[distances.size - 2]
    }

    val count: Int get() = others.size

    private fun middleOf(sorted: DoubleArray) = (sorted[(sorted.size - 1) / 2] + sorted[sorted.size / 2]) / 2

    private companion object {
        const val NORMAL = 1.4826
    }
}
