package badlog.rules.number

import kotlin.math.abs

/**
 * The median of a number in the team's other logs, and their usual distance from it. The usual distance is 1.4826 times the median absolute
 * deviation, which for a normal distribution is the standard deviation. A single unusual log changes neither.
 *
 * @property second the distance of the second farthest log from the median.
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
}

private const val NORMAL = 1.4826
