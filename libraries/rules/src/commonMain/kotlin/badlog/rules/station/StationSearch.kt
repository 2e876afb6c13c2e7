package badlog.rules.station

/**
 * Which Driver Station log is of the same match as a log of the robot, and how it stands on that one's clock.
 *
 * @property log what it was found as.
 */
public class FoundStation<out F>(public val log: F, public val station: ClockedLog, public val fit: ClockFit)

/**
 * Finds the Driver Station log of the match that [robot] is the log of: by the time of day, or else by the match, or else by when the robot
 * was enabled. Clocks of robots are often wrong, so each may be all there is.
 *
 * @param startOf when one began, in s since 1970, as far as that is known before it is read; null where it is not.
 * @param read reads one; null for what is none.
 */
public class StationSearch<F>(private val robot: ClockedLog, private val startOf: (F) -> Double?, private val read: (F) -> ClockedLog?) {
    private class Candidate<F>(val log: F, val station: ClockedLog)

    /**
     * The one of [logs]; null when none can be told to be it.
     *
     * @param acceptsOnly whether the only one that there is will do, though nothing but a moment of enabled speaks for it.
     * @param mostRead of more logs than these only those are read that may be of the time of day.
     */
    public fun over(logs: List<F>, acceptsOnly: Boolean = false, mostRead: Int = Int.MAX_VALUE): FoundStation<F>? {
        if (!robot.hasClock) return null
        // A Driver Station writes one log after another, so those that began last are of the time.
        val near = logs.filter(::mayBeAtTime).sortedByDescending { startOf(it) ?: Double.POSITIVE_INFINITY }.take(MOST_AT_TIME).toSet()
        val atTime = near.mapNotNull(::candidate)
        byTime(atTime)?.let { found -> fitOf(found.station)?.let { return FoundStation(found.log, found.station, it) } }
        if (logs.size > mostRead) return null
        val all = atTime + logs.filter { it !in near }.mapNotNull(::candidate)
        val found = byMatch(all) ?: byEdges(all) ?: all.singleOrNull()?.takeIf { acceptsOnly } ?: return null
        return fitOf(found.station)?.let { FoundStation(found.log, found.station, it) }
    }

    /** How [station] stands on the robot's clock, by the moments of enabled, or else by the time of day; null where neither tells it. */
    private fun fitOf(station: ClockedLog): ClockFit? {
        val byClocks = station.start?.let { start -> robot.start?.let { start - it } }
        val byEdges = ClockFit.ofEdges(station.edges, robot.edges, byClocks)
        // A single edge may be any other one.
        val isBelievable =
            byEdges != null && (byClocks == null || byEdges.edges > 1 || byEdges.seconds - byClocks in -NEAR_CLOCKS..NEAR_CLOCKS)
        return if (isBelievable || byClocks == null) byEdges else ClockFit(byClocks, 0, CLOCK_ERROR)
    }

    private fun candidate(log: F): Candidate<F>? = read(log)?.takeIf { it.hasClock }?.let { Candidate(log, it) }

    private fun mayBeAtTime(log: F): Boolean {
        val start = robot.start ?: return false
        val begin = startOf(log) ?: return true
        return begin < start + robot.last && begin > start + robot.first - LONGEST
    }

    /** The one that has the most of the time in which the robot's log was made. */
    private fun byTime(candidates: List<Candidate<F>>): Candidate<F>? {
        val start = robot.start ?: return null
        fun common(candidate: Candidate<F>): Double = candidate.station.run {
            this.start?.let { minOf(start + robot.last, it + last) - maxOf(start + robot.first, it + first) } ?: 0.0
        }
        return candidates.filter { common(it) > 0 }.maxByOrNull(::common)
    }

    private fun byMatch(candidates: List<Candidate<F>>): Candidate<F>? {
        val match = robot.match ?: return null
        return candidates.filter { it.station.match == match }.singleOrNull()
    }

    /** The only one that has all moments of enabled that the robot's log has, or nearly all where there are many. */
    private fun byEdges(candidates: List<Candidate<F>>): Candidate<F>? {
        val needed = maxOf(FEWEST_EDGES, robot.edges.size * 9 / 10)
        if (robot.edges.size < FEWEST_EDGES) return null
        return candidates.filter { (ClockFit.ofEdges(it.station.edges, robot.edges)?.edges ?: 0) >= needed }.singleOrNull()
    }

    private companion object {
        /** So many logs may begin while a robot's log goes on, and before it. */
        const val MOST_AT_TIME = 16

        /** No Driver Station log is longer, in s. */
        const val LONGEST = 86_400.0

        /** A match has two: it begins and ends. */
        const val FEWEST_EDGES = 2

        /** What clocks that were set by each other differ by at most, in s. */
        const val NEAR_CLOCKS = 5.0

        /** Both clocks are known to the second. */
        const val CLOCK_ERROR = 1.0
    }
}
