package badlog.viewer.shown.swerve

/**
 * The moments in which something changes. A robot sends the values of a loop one after the other, so that their times differ by parts of a
 * millisecond; all changes of a loop are one moment, or a new target would be compared with an old measurement.
 *
 * @property from when each moment begins, ascending.
 * @property until the last change of each.
 */
internal class Moments private constructor(val from: DoubleArray, val until: DoubleArray) {
    companion object {
        /** Changes that are less apart are one moment, in s. */
        private const val CLOSE = 0.005

        /** A moment is shorter than this also where changes are always close, in s. */
        private const val LONGEST = 0.01

        /** Returns those of the changes in [lists], each of which is ascending. */
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
