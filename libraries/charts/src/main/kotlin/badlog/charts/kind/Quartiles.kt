package badlog.charts.kind

/**
 * The quartiles of some numbers.
 *
 * @property lower a quarter of the numbers is below this one.
 * @property median half of the numbers is below this one.
 * @property upper a quarter of the numbers is above this one.
 */
internal class Quartiles(val lower: Double, val median: Double, val upper: Double) {
    /** The distance from a quartile beyond which a number is an outlier, according to Tukey. */
    val fence: Double get() = 1.5 * (upper - lower)

    companion object {
        /** Returns the quartiles of [values], which must not be empty. */
        fun of(values: List<Double>): Quartiles = values.sorted().let { Quartiles(it.at(0.25), it.at(0.5), it.at(0.75)) }

        private fun List<Double>.at(share: Double): Double {
            val place = share * (size - 1)
            val below = place.toInt()
            val above = minOf(below + 1, size - 1)
            return this[below] + (place - below) * (this[above] - this[below])
        }
    }
}
