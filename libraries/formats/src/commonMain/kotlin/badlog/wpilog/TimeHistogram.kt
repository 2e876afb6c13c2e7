package badlog.wpilog

/**
 * Finds the times from 0 on that most records of a file are near, in memory that does not grow: counts records in buckets of 19 hours.
 * What is a whole bucket away from the others does not belong to the same run of a robot.
 */
internal class TimeHistogram {
    private val starts = DoubleArray(MAX_BUCKETS)
    private val counts = DoubleArray(MAX_BUCKETS)
    private val first = DoubleArray(MAX_BUCKETS)
    private var size = 0
    private var current = -1
    private var currentFrom = 0.0

    /** Counts a record at [micros]. False when it cannot be kept: a time that cannot be, or too many far apart. */
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

    /** Where most records are; the last moment is not part of it any more. Null without any. */
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

    /** How many records were counted. */
    fun total(): Double = counts.sum()

    /** The times from [from] on and before [until], in µs, at which [records] stand. */
    class Cluster(val from: Double, val until: Double, val records: Double)

    companion object {
        private const val MAX_BUCKETS = 64

        /** 2^36 µs, 19 hours. */
        private const val WIDTH = 68719476736.0

        /** 2^53 µs, 285 years: from there on µs are not exact, and no robot runs. */
        const val NEVER = 9007199254740992.0
    }
}
