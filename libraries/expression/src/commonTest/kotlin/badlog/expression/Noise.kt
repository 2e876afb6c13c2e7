package badlog.expression

import kotlin.random.Random

/**
 * Random rounding in the other direction. If an answer depends on it, such as whether 0.1 + 0.2 is above 0.3, no single answer is right,
 * and none is compared.
 *
 * @property tick the time that setting back a clock takes, in s.
 */
internal class Noise private constructor(private val random: Random?, val tick: Double) {
    /** Returns [value] as another order of calculation might give it; a value that is exact in binary is unchanged. */
    fun of(value: Double): Double = when {
        random == null || !value.isFinite() -> value
        else -> value * (1 + random.nextDouble(-SHARE, SHARE))
    }

    /** Does the same for a sum, which is exact if its parts are. */
    fun ofSum(value: Double): Double = if ((value * EXACT) % 1.0 == 0.0) value else of(value)

    companion object {
        private const val SHARE = 1e-13
        private const val EXACT = 1L shl 20

        val NONE = Noise(null, 1.0 / (1L shl 40))

        fun of(seed: Int) = Noise(Random(seed), (1.0 + seed % 3) / (1L shl 41))
    }
}
