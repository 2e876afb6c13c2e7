package badlog.signals.clock

/**
 * The Driver Station log of the same match as a robot's log, and how its clock relates to the robot's.
 *
 * @property log the log that was found.
 */
class FoundStation<out F>(val log: F, val station: ClockedLog, val fit: ClockFit)

/**
 * Finds the Driver Station log of the same match as the log [robot]: by the time of day, or else by the match, or else by when the robot
 * was enabled. Clocks of robots are often wrong, so any of these may be the only clue.
 *
 * @param startOf returns when a log began, in s since 1970, if that is known before it is read; otherwise null.
 * @param read reads a log; returns null if it is not one.
 */
class StationSearch<F>(private val robot: ClockedLog, private val startOf: (F) -> Double?, private val read: (F) -> ClockedLog?) {
    private class Candidate<F>(val log: F, val station: ClockedLog)

    /**
     * Returns the matching one of [logs]; null if none can be identified.
     *
     * @param acceptsOnly whether to accept the only log, even if just one moment of enabling matches.
     * @param mostRead if there are more logs than this, only those that may match by time of day are read.
     */
    fun over(logs: List<F>, acceptsOnly: Boolean = false, mostRead: Int = Int.MAX_VALUE): FoundStation<F>? {
        if (!robot.hasClock) return null
        // A Driver Station writes one log after another, so the matching logs are those that began last before the time.
        val near = logs.filter(::mayBeAtTime).sortedByDescending { startOf(it) ?: Double.POSITIVE_INFINITY }.take(MOST_AT_TIME).toSet()
        val atTime = near.mapNotNull(::candidate)
        byTime(atTime)?.let { found -> fitOf(found.station)?.let { return FoundStation(found.log, found.station, it) } }
        if (logs.size > mostRead) return null
        val all = atTime + logs.filter { it !in near }.mapNotNull(::candidate)
        val found = byMatch(all) ?: byEdges(all) ?: all.singleOrNull()?.takeIf { acceptsOnly } ?: return null
        return fitOf(found.station)?.let { FoundStation(found.log, found.station, it) }
    }

    /**
     * Returns how the clock of [station] relates to the robot's, by the moments of enabling, or else by the time of day; null if neither
     * shows it.
     */
    private fun fitOf(station: ClockedLog): ClockFit? {
        val byClocks = station.start?.let { start -> robot.start?.let { start - it } }
        val byEdges = ClockFit.ofEdges(station.edges, robot.edges, byClocks)
        // A single edge may match any other one.
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

    /** Returns the candidate that covers most of the time of the robot's log. */
    private fun byTime(candidates: List<Candidate<F>>): Candidate<F>? {
        val start = robot.start ?: return null
        fun common(candidate: Candidate<F>): Double = candidate.station.run {
            this.start?.let { minOf(start + robot.last, it + last) - maxOf(start + robot.first, it + first) } ?: 0.0
        }
        return candidates.filter { common(it) > 0 }.maxByOrNull(::common)
    }

    private fun byMatch(candidates: List<Candidate<F>>): Candidate<F>? {
        val match = robot.match.match ?: return null
        return candidates.filter { it.station.match.match == match }.singleOrNull()
    }

    /** Returns the only candidate with all moments of enabling in the robot's log, or nearly all if there are many. */
    private fun byEdges(candidates: List<Candidate<F>>): Candidate<F>? {
        val needed = maxOf(FEWEST_EDGES, robot.edges.size * 9 / 10)
        if (robot.edges.size < FEWEST_EDGES) return null
        return candidates.filter { (ClockFit.ofEdges(it.station.edges, robot.edges)?.edges ?: 0) >= needed }.singleOrNull()
    }

    private companion object {
        /** The maximum number of logs that may begin before and during a robot's log. */
        const val MOST_AT_TIME = 16

        /** The maximum length of a Driver Station log, in s. */
        const val LONGEST = 86_400.0

        /** A match has at least two: its start and its end. */
        const val FEWEST_EDGES = 2

        /** The maximum difference between clocks that were set by each other, in s. */
        const val NEAR_CLOCKS = 5.0

        /** Both clocks are known to the second. */
        const val CLOCK_ERROR = 1.0
    }
}
