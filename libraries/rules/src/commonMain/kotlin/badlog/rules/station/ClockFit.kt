package badlog.rules.station

import kotlin.math.abs
import kotlin.math.round

/**
 * How one log stands on the clock of another.
 *
 * @property seconds how much later its times are there, in s, to the microsecond.
 * @property edges how many moments of enabled and disabled fit; 0 where only clocks or names tell.
 * @property error how far those are from the other log's at most, in s; where there are none, how far the clocks may be off.
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
            val best = own.flatMap { edge -> others.filter { it.isRise == edge.isRise }.map { it.seconds - edge.seconds } }
                .map { candidate -> movesAt(candidate, own, others) }
                .maxWithOrNull(compareBy({ it.size }, { -distance(it) })) ?: return null
            val seconds = round(best.average() * MICROS) / MICROS
            return ClockFit(seconds, best.size, best.maxOf { abs(it - seconds) })
        }

        /** By how much each of [own] would have to move to be one of [others], of those that are near it when all move by [candidate]. */
        private fun movesAt(candidate: Double, own: List<EnabledEdge>, others: List<EnabledEdge>): List<Double> = own.mapNotNull { edge ->
            var best = Double.NaN
            for (other in others) {
                val move = other.seconds - edge.seconds
                if (other.isRise == edge.isRise && !(abs(move - candidate) >= abs(best - candidate))) best = move
            }
            best.takeIf { abs(it - candidate) <= NEAR_SECONDS }
        }

        /** Clocks of one robot differ by no more while it runs for some minutes. */
        private const val NEAR_SECONDS = 0.25
        private const val MICROS = 1e6
    }
}
