package badlog.rules.number

import kotlin.math.abs

/**
 * The same number in the team's other logs. It has its median, and the usual distance from it (1.4826 times the median absolute deviation,
 * which for a normal distribution is the standard deviation). A single unusual log changes neither.
 *
 * @property second the distance from the median of the second farthest log.
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
