package badlog.charts.kind

/**
 * The middle of some numbers.
 *
 * @property lower the number below which a quarter of them is.
 * @property median the number below which half of them is.
 * @property upper the number above which a quarter of them is.
 */
internal class Quartiles(val lower: Double, val median: Double, val upper: Double) {
    /** The distance from a quartile from which on a number is called an outlier: Tukey's. */
    val fence: Double get() = 1.5 * (upper - lower)

    companion object {
        /** Returns those of [values], at least one. */
        fun of(values: List<Double>): Quartiles = values.sorted().let { Quartiles(it.at(0.25), it.at(0.5), it.at(0.75)) }

        private fun List<Double>.at(share: Double): Double {
            val place = share * (size - 1)
            val below = place.toInt()
            val above = minOf(below + 1, size - 1)
            return this[below] + (place - below) * (this[above] - this[below])
        }
    }
}
