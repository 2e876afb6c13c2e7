package badlog.rules.station

import kotlin.math.abs
import kotlin.math.round

/**
 * How one log stands on the clock of another.
 *
 * @property seconds how much later its times are there, in s, to the microsecond.
 * @property edges how many moments of enabled and disabled fit; 0 where only clocks or names tell.
 * @property error how far those are from the other log's at most, in s, to the microsecond; where there are none, how far the clocks may be off.
 */
public class ClockFit(public val seconds: Double, public val edges: Int, public val error: Double) {
    public companion object {
        /**
         * How [own] stand on the clock of [others], so that as many as can are at one of those; null when none can.
         *
         * @param near by how many seconds the clocks differ, where something tells it: of several fits with as many edges, the one nearest
         *   to it counts.
         */
        public fun ofEdges(own: List<EnabledEdge>, others: List<EnabledEdge>, near: Double? = null): ClockFit? {
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

        /** By how much each of [own] would have to move to be one of the others, of those that are near one when all move by [candidate]. */
        private fun movesAt(candidate: Double, own: List<EnabledEdge>, rises: DoubleArray, falls: DoubleArray): List<Double> =
            own.mapNotNull { edge ->
                val nearest = (if (edge.isRise) rises else falls).nearest(edge.seconds + candidate) ?: return@mapNotNull null
                (nearest - edge.seconds).takeIf { abs(it - candidate) <= NEAR_SECONDS }
            }

        private fun timesOf(edges: List<EnabledEdge>, isRise: Boolean) =
            edges.filter { it.isRise == isRise }.map { it.seconds }.sorted().toDoubleArray()

        /** The one of these, which ascend, that is nearest to [x]; null without any. */
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

        /** Clocks of one robot differ by no more while it runs for some minutes. */
        private const val NEAR_SECONDS = 0.25
        private const val MICROS = 1e6
    }
}
