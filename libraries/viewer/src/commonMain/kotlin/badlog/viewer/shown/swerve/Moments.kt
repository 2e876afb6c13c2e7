package badlog.viewer.shown.swerve

/**
 * The moments at which something changes. A robot sends the values of a loop one after the other, so that their times differ by fractions
 * of a millisecond. All changes of a loop are one moment; otherwise a new target would be compared with an old measurement.
 *
 * @property from the start of each moment, ascending.
 * @property until the last change of each moment.
 */
internal class Moments private constructor(val from: DoubleArray, val until: DoubleArray) {
    companion object {
        /** The time in s below which two changes are one moment. */
        private const val CLOSE = 0.005

        /** The maximum length of a moment in s, even if changes are always close. */
        private const val LONGEST = 0.01

        /** Returns the moments of the changes in [lists]. Each list is ascending. */
        fun of(lists: List<DoubleArray>): Moments {
            // The fields of a struct share an array, and arrays are only equal to themselves.
            val all = lists.distinct()
            val at = IntArray(all.size)
            val from = DoubleArray(all.sumOf { it.size })
            val until = DoubleArray(from.size)
            var count = 0
            while (true) {
                var next = Double.POSITIVE_INFINITY
                for (k in all.indices) if (at[k] < all[k].size) next = minOf(next, all[k][at[k]])
                if (next == Double.POSITIVE_INFINITY) return Moments(from.copyOf(count), until.copyOf(count))
                for (k in all.indices) while (at[k] < all[k].size && all[k][at[k]] <= next) at[k]++
                if (count == 0 || next - until[count - 1] >= CLOSE || next - from[count - 1] >= LONGEST) from[count++] = next
                until[count - 1] = next
            }
        }
    }
}
