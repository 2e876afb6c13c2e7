package badlog.viewer.shown.statistics

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Span
import badlog.core.analysis.XAxis
import badlog.viewer.choices.range.holdsUntil
import badlog.viewer.text.exactText
import badlog.viewer.text.lengthText
import badlog.viewer.text.numberText
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit
import kotlin.math.abs

/**
 * The difference between two lines of a graph.
 *
 * @property one the first line.
 * @property other the line that is subtracted from it.
 * @param width the length of the examined part of x.
 */
class NamedDifference(val one: GraphSeries, val other: GraphSeries, private val difference: LineDifference, private val width: Double) {
    /** Returns the displayed values, in the order of [TITLES]; [offset] is added to the place. */
    fun texts(axis: XAxis, offset: Double = 0.0): List<String> = with(difference) {
        listOf(
            withUnit(numberText(mean), one.unit),
            withUnit(numberText(rms), one.unit),
            withUnit(numberText(largest), one.unit),
            withUnit(placeText(largestAt + offset, axis, width), axis.unit),
            lag?.let { "${lengthText(abs(it), axis)} ${if (it >= 0) "behind" else "ahead"}" } ?: "–",
        )
    }

    /** Returns the values to the last digit, without units; [offset] is added to the place. */
    fun exactTexts(offset: Double = 0.0): List<String> = with(difference) {
        listOf(exactText(mean), exactText(rms), exactText(largest), exactText(largestAt + offset), lag?.let(::exactText) ?: "–")
    }

    companion object {
        /** The titles of the [texts]. */
        val TITLES: List<String> = listOf("mean", "RMS", "largest", "at", "lag")

        /** The meanings of the titles, one sentence each. */
        val HINTS: List<String> = listOf(
            "the mean difference by time",
            "the root mean square of the difference: the usual measure of how well something follows",
            "the difference that is farthest from 0",
            "where the largest difference is",
            "how far the line is behind the other, if shifting it makes them fit much better",
        )

        /** The maximum number of differences that a graph shows. */
        const val MAX_SHOWN: Int = 6

        /**
         * Returns the differences of a graph's [lines] within [parts] of x, at most [MAX_SHOWN]. Each is between a line and the first one
         * of its unit.
         */
        fun of(lines: List<GraphSeries>, parts: List<Span>): List<NamedDifference> {
            val width = parts.sumOf { it.width }
            fun endOf(line: GraphSeries) = line.holdsUntil ?: line.data.range?.endInclusive ?: Double.NaN
            val pairs = lines.filter {
                it.states == null
            }.groupBy { it.unit }.values.flatMap { alike -> alike.drop(1).map { it to alike[0] } }
            return pairs.take(MAX_SHOWN).mapNotNull { (line, first) ->
                differenceOf(line.data, first.data, parts, first.unit, endOf(line), endOf(first))?.let {
                    NamedDifference(line, first, it, width)
                }
            }
        }
    }
}
