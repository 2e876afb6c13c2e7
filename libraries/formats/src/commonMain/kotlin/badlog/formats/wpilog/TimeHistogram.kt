package badlog.formats.wpilog

/**
 * Finds the times, from 0 on, around which most records of a file are. Its memory does not grow: it counts records in buckets of 19 hours. Records a
 * whole bucket away from the others do not belong to the same run of a robot.
 */
internal class TimeHistogram {
    private val starts = DoubleArray(MAX_BUCKETS)
    private val counts = DoubleArray(MAX_BUCKETS)
    private val first = DoubleArray(MAX_BUCKETS)
    private var size = 0
    private var current = -1
    private var currentFrom = 0.0

    /** Counts a record at [micros]. Returns false if it must be dropped: its time is impossible, or there are too many times far apart. */
    fun add(micros: Double): Boolean {
        if (current < 0 || micros < currentFrom || micros >= currentFrom + WIDTH) {
            if (micros >= NEVER || !find(micros)) return false
        }
        counts[current]++
        if (micros < first[current]) first[current] = micros
        return true
    }

    private fun find(micros: Double): Boolean {
        val start = kotlin.math.floor(micros / WIDTH) * WIDTH
        var bucket = 0
        while (bucket < size && starts[bucket] != start) bucket++
        if (bucket == MAX_BUCKETS) return false
        if (bucket == size) {
            starts[bucket] = start
            first[bucket] = micros
            size++
        }
        current = bucket
        currentFrom = start
        return true
    }

    /** Returns the span with most of the records; null if there are none. */
    fun largestCluster(): Cluster? {
        val order = (0 until size).sortedBy { starts[it] }
        var best: Cluster? = null
        var records = 0.0
        var from = 0
        for (i in order.indices) {
            records += counts[order[i]]
            val isLast = i == order.lastIndex || starts[order[i + 1]] > starts[order[i]] + WIDTH
            if (!isLast) continue
            if (best == null || records > best.records) {
                best = Cluster(first[order[from]], starts[order[i]] + WIDTH, records)
            }
            from = i + 1
            records = 0.0
        }
        return best
    }

    /** Returns the number of counted records. */
    fun total(): Double = counts.sum()

    /** The times from [from] until before [until], in µs, which have [records] records. */
    class Cluster(val from: Double, val until: Double, val records: Double)

    companion object {
        private const val MAX_BUCKETS = 64

        /** 2^36 µs, 19 hours. */
        private const val WIDTH = 68719476736.0

        /** 2^53 µs, 285 years: beyond that, µs are not exact, and no robot runs for so long. */
        const val NEVER = 9007199254740992.0
    }
}
