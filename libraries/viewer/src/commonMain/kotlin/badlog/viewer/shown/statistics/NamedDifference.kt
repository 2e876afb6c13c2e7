package badlog.viewer.shown.statistics

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Span
import badlog.core.analysis.XAxis
import badlog.viewer.text.lengthText
import badlog.viewer.text.numberText
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit
import kotlin.math.abs

/**
 * How a line of a graph differs from another one of it.
 *
 * @property one the first line.
 * @property other the line that is subtracted from it.
 * @param width the part of x that was looked at.
 */
class NamedDifference(val one: GraphSeries, val other: GraphSeries, private val difference: LineDifference, private val width: Double) {
    /** Returns its values for people, under [TITLES]. */
    fun texts(axis: XAxis): List<String> = with(difference) {
        listOf(
            withUnit(numberText(mean), one.unit),
            withUnit(numberText(rms), one.unit),
            withUnit(numberText(largest), one.unit),
            withUnit(placeText(largestAt, axis, width), axis.unit),
            lag?.let { "${lengthText(abs(it), axis)} ${if (it >= 0) "behind" else "ahead"}" } ?: "–",
        )
    }

    companion object {
        /** The titles of what [texts] returns. */
        val TITLES: List<String> = listOf("mean", "RMS", "largest", "at", "lag")

        /** What the titles mean, in one sentence each. */
        val HINTS: List<String> = listOf(
            "the mean difference by time",
            "the root mean square of the difference: the usual measure of how well something follows",
            "the difference that is farthest from 0",
            "where the largest difference is",
            "how far the line is behind the other, if shifting it makes them fit much better",
        )

        /** More than anybody compares in one graph. */
        private const val MOST = 6

        /**
         * Returns how the lines after the first of [lines], which are those of a graph, differ from the first within [parts] of x; only those
         * with numbers of the same unit.
         */
        fun of(lines: List<GraphSeries>, parts: List<Span>): List<NamedDifference> {
            val numbers = lines.filter { it.states == null }
            val first = numbers.firstOrNull() ?: return emptyList()
            val width = parts.sumOf { it.width }
            return numbers.drop(1).filter { it.unit == first.unit }.take(MOST).mapNotNull { line ->
                differenceOf(line.data, first.data, parts, first.unit)?.let { NamedDifference(line, first, it, width) }
            }
        }
    }
}
