package badlog.viewer.graph.plot

import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow

/**
 * The places of an axis that are labelled: multiples of [step], which is 1, 2 or 5 times a power of ten.
 *
 * @property values them, ascending.
 */
internal class Ticks private constructor(val values: DoubleArray, val step: Double) {
    companion object {
        /** No more than [most] ticks from [from] to [to]; none where that is no range. */
        fun of(from: Double, to: Double, most: Int): Ticks {
            val width = to - from
            if (!(width > 0) || !width.isFinite() || most < 1) return Ticks(DoubleArray(0), 1.0)
            val step = stepFor(width / most)
            val first = ceil(from / step)
            // Where neighbouring numbers are further apart than the step, there is nothing to count.
            val count = (floor(to / step) - first + 1).coerceIn(0.0, most + 1.0).toInt()
            return Ticks(DoubleArray(count) { (first + it) * step + 0.0 }, step)
        }

        private fun stepFor(least: Double): Double {
            val power = 10.0.pow(floor(log10(least)))
            val factor = FACTORS.firstOrNull { it * power >= least * (1 - ROUNDING) } ?: FACTORS.last()
            return factor * power
        }

        private val FACTORS = doubleArrayOf(1.0, 2.0, 5.0, 10.0)
        private const val ROUNDING = 1e-9
    }
}
