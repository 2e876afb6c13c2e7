package badlog.expression

import kotlin.random.Random

/**
 * Rounding that may as well have gone the other way: where an answer hangs on it, as whether 0.1 + 0.2 is above 0.3, there is no
 * right one, and nothing to compare.
 *
 * @property tick how long it takes to set back a clock, in s.
 */
internal class Noise private constructor(private val random: Random?, val tick: Double) {
    /** [value] as another order of calculation may have it; one that is exact in binary stays. */
    fun of(value: Double): Double = when {
        random == null || !value.isFinite() -> value
        else -> value * (1 + random.nextDouble(-SHARE, SHARE))
    }

    /** The same of a sum, which is exact where its parts are. */
    fun ofSum(value: Double): Double = if ((value * EXACT) % 1.0 == 0.0) value else of(value)

    companion object {
        private const val SHARE = 1e-13
        private const val EXACT = 1L shl 20

        val NONE = Noise(null, 1.0 / (1L shl 40))

        fun of(seed: Int) = Noise(Random(seed), (1.0 + seed % 3) / (1L shl 41))
    }
}
