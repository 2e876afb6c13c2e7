package badlog.viewer.shown.statistics

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Series
import badlog.core.analysis.SeriesStatistics
import badlog.core.analysis.Span
import badlog.viewer.choices.range.holdsUntil

/**
 * The distribution of a line's values over time. Each value counts as long as it holds, as for the statistics.
 *
 * @property values the values from the smallest to the largest, which the bins divide evenly.
 * @property shares the share of the time in each bin, 0 to 1, together 1.
 */
class Histogram internal constructor(val values: Span, val shares: DoubleArray) {
    companion object {
        /** A displayed explanation. */
        const val HINT: String = "The share of time at each value"

        /** The sentence for a line without a histogram. */
        const val NONE: String = "There is no histogram: it needs two different values over time."

        private const val BINS = 30

        /**
         * Returns the histogram of [line] over [parts] of x, which are in order; its [statistics] are over the same parts. Null if it has
         * states, if it has only one value, or if x goes backwards.
         */
        fun of(line: GraphSeries, parts: List<Span>, statistics: SeriesStatistics): Histogram? {
            val values = Span(statistics.min, statistics.max)
            if (line.states != null || !line.data.isOrdered || !(values.width > 0) || !values.width.isFinite()) return null
            val end = line.holdsUntil ?: Double.NaN
            val times = DoubleArray(BINS)
            for (part in parts) line.data.addTimes(times, part, values, end)
            val all = times.sum()
            return if (all > 0) Histogram(values, DoubleArray(BINS) { times[it] / all }) else null
        }

        private fun Series.addTimes(times: DoubleArray, part: Span, values: Span, end: Double) {
            for (i in maxOf(0, firstAfter(part.from) - 1) until firstAfter(part.to)) {
                val until = if (i + 1 < size) x[i + 1] else end
                val time = minOf(until, part.to) - maxOf(x[i], part.from)
                if (!(time > 0) || !y[i].isFinite()) continue
                times[((y[i] - values.from) / values.width * BINS).toInt().coerceIn(0, BINS - 1)] += time
            }
        }
    }
}
