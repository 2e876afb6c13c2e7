package badlog.signals.clock

import kotlin.math.abs
import kotlin.math.round

/**
 * The relation of one log's clock to another's.
 *
 * @property seconds the offset to add to its times, in s, to the microsecond.
 * @property edges the number of moments of enabling and disabling that match; 0 if only clocks or names were used.
 * @property error the largest distance of a matching moment from the other log's, in s, to the microsecond; if none match, the possible error of the
 *   clocks.
 */
class ClockFit(val seconds: Double, val edges: Int, val error: Double) {
    companion object {
        /**
         * Returns the relation of the clock of [own] to the clock of [others] at which most edges match. Null if none can.
         *
         * @param near the estimated difference of the clocks in seconds, if known: among several fits with equally many edges, the one
         *   nearest to it counts.
         */
        fun ofEdges(own: List<EnabledEdge>, others: List<EnabledEdge>, near: Double? = null): ClockFit? {
            fun distance(fits: List<Double>): Double {
                val mean = fits.average()
                return if (near != null) abs(mean - near) else fits.sumOf { abs(it - mean) }
            }
            val rises = timesOf(others, isRise = true)
            val falls = timesOf(others, isRise = false)
            val best = own.flatMap { edge -> (if (edge.isRise) rises else falls).map { it - edge.seconds } }
                .map { candidate -> movesAt(candidate, own, rises, falls) }
                .maxWithOrNull(compareBy({ it.size }, { -distance(it) })) ?: return null
            val seconds = toMicros(best.average())
            return ClockFit(seconds, best.size, toMicros(best.maxOf { abs(it - seconds) }))
        }

        private fun toMicros(seconds: Double) = round(seconds * MICROS) / MICROS

        /** Returns the exact offset of each of [own] that is near one of the others when all move by [candidate]. */
        private fun movesAt(candidate: Double, own: List<EnabledEdge>, rises: DoubleArray, falls: DoubleArray): List<Double> =
            own.mapNotNull { edge ->
                val nearest = (if (edge.isRise) rises else falls).nearest(edge.seconds + candidate) ?: return@mapNotNull null
                (nearest - edge.seconds).takeIf { abs(it - candidate) <= NEAR_SECONDS }
            }

        private fun timesOf(edges: List<EnabledEdge>, isRise: Boolean) =
            edges.filter { it.isRise == isRise }.map { it.seconds }.sorted().toDoubleArray()

        /** Returns the number nearest to [x] in this ascending array; null if it is empty. */
        private fun DoubleArray.nearest(x: Double): Double? {
            var low = 0
            var high = size
            while (low < high) {
                val middle = (low + high) / 2
                if (this[middle] < x) low = middle + 1 else high = middle
            }
            val before = getOrNull(low - 1)
            val after = getOrNull(low)
            return if (after == null || (before != null && x - before <= after - x)) before else after
        }

        /** Clocks of one robot drift by at most this within some minutes. */
        private const val NEAR_SECONDS = 0.25
        private const val MICROS = 1e6
    }
}
