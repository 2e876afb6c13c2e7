package badlog.cli.cut

import badlog.core.analysis.Span
import java.util.IdentityHashMap
import kotlin.math.round

/**
 * The kept samples of topics that share their times.
 *
 * @property indices the indices of the samples; one may occur several times if it holds in several spans.
 * @property times the time of each of them in the part.
 */
internal class ClockPart private constructor(val indices: IntArray, val times: DoubleArray) {
    /** Finds the samples in [spans], which ascend; with [holdsValues], also the samples that hold at the start of a span. */
    class Cache(private val spans: List<Span>, private val holdsValues: Boolean) {
        private val known = IdentityHashMap<DoubleArray, ClockPart>()

        /** Returns the kept samples among those at [times], which ascend. */
        fun of(times: DoubleArray): ClockPart = known.getOrPut(times) { find(times) }

        private fun find(times: DoubleArray): ClockPart {
            val indices = IntArray(times.size + spans.size)
            val kept = DoubleArray(indices.size)
            var size = 0
            for (span in spans) {
                val first = firstWhere(times) { it >= span.from }
                val until = firstWhere(times) { it > span.to }
                val begin = round(span.from * MICROS) / MICROS
                if (holdsValues && first > 0 && (first == until || times[first] > begin)) {
                    indices[size] = first - 1
                    kept[size] = if (size == 0) begin else maxOf(begin, kept[size - 1])
                    size++
                }
                for (index in first until until) {
                    indices[size] = index
                    kept[size++] = times[index]
                }
            }
            return ClockPart(indices.copyOf(size), kept.copyOf(size))
        }
    }

    private companion object {
        /** The microseconds in a second. Times in a WPILOG are whole microseconds. */
        const val MICROS = 1e6

        /** Returns the first index in [times] at which [isThere] is true. Times must ascend, and it must be true for all later ones. */
        inline fun firstWhere(times: DoubleArray, isThere: (Double) -> Boolean): Int {
            var low = 0
            var high = times.size
            while (low < high) {
                val middle = (low + high) ushr 1
                if (isThere(times[middle])) high = middle else low = middle + 1
            }
            return low
        }
    }
}
