package badlog.signals.clock

import badlog.signals.match.MatchOfLog
import badlog.signals.match.isSameAs

/**
 * The Driver Station log of the same match as a robot's log, and how its clock relates to the robot's.
 *
 * @property log the log that was found.
 */
class FoundStation<out F>(val log: F, val station: ClockedLog, val fit: ClockFit)

/**
 * Finds the Driver Station log of the same match as the log [robot]. It compares the matches, otherwise the times of enabling, otherwise
 * the times of day. Clocks are often wrong, so any of these may be the only clue.
 *
 * @param startOf returns when a log began, in s since 1970, if that is known before it is read; otherwise null.
 * @param read reads a log; returns null if it is not one.
 */
class StationSearch<F>(private val robot: ClockedLog, private val startOf: (F) -> Double?, private val read: (F) -> ClockedLog?) {
    private class Candidate<F>(val log: F, val station: ClockedLog)

    /**
     * Returns the matching one of [logs]; null if none can be identified. A log of another match is never returned, even if its clock fits:
     * a laptop's may be an hour off. Among several, one of the same match is preferred, then one with the same moments of enabling and
     * clock.
     *
     * @param acceptsOnly whether to accept the only log, even if just one moment of enabling matches.
     * @param mostRead if there are more logs than this, only those that may match by time of day are read.
     */
    fun over(logs: List<F>, acceptsOnly: Boolean = false, mostRead: Int = Int.MAX_VALUE): FoundStation<F>? {
        if (!robot.hasClock) return null
        // A Driver Station writes one log after another, so the matching logs are those that began last before the time.
        val near = logs.filter(::mayBeAtTime).sortedByDescending { startOf(it) ?: Double.POSITIVE_INFINITY }.take(MAX_AT_TIME).toSet()
        val atTime = possible(near)
        val found = sure(atTime)
            ?: any(atTime + if (logs.size > mostRead) emptyList() else possible(logs.filter { it !in near }), acceptsOnly)
        return found?.let { fitOf(it.station)?.let { fit -> FoundStation(it.log, it.station, fit) } }
    }

    private fun possible(logs: Collection<F>) = logs.mapNotNull(::candidate).filterNot { isOfAnother(it.station.match) }

    /** Returns the one of [candidates] than which no log of another time of day can be better. Null if there is none. */
    private fun sure(candidates: List<Candidate<F>>): Candidate<F>? {
        val (same, open) = candidates.partition { isOfSame(it.station.match) }
        if (robot.edges.size < MIN_EDGES) return same.singleOrNull() ?: byTime(same) ?: byTime(open)
        val (own, others) = withEdges(candidates).partition { it in same }
        return first(own.filter { agrees(it, 0.0) }) ?: first(own.filter(::agreesButForAnHour)) ?: first(others.filter { agrees(it, 0.0) })
    }

    /** Returns the best of [candidates], which are all there are; null if that is not clear. A replayed match has the same number. */
    private fun any(candidates: List<Candidate<F>>, acceptsOnly: Boolean): Candidate<F>? {
        sure(candidates)?.let { return it }
        val (same, open) = candidates.partition { isOfSame(it.station.match) }
        val withEdges = withEdges(candidates)
        return withEdges.filter { it in open && agreesButForAnHour(it) }.singleOrNull()
            ?: same.singleOrNull()
            ?: withEdges.singleOrNull()
            ?: byTime(candidates).takeIf { withEdges.isEmpty() }
            ?: candidates.singleOrNull()?.takeIf { acceptsOnly }
    }

    private fun first(candidates: List<Candidate<F>>) = if (candidates.size > 1) byTime(candidates) else candidates.firstOrNull()

    private fun isOfAnother(match: MatchOfLog): Boolean = robot.match.isSameAs(match) == false

    private fun isOfSame(match: MatchOfLog): Boolean = robot.match.isSameAs(match) == true

    /** Returns the [candidates] with all moments of enabling in the robot's log, or nearly all if there are many. */
    private fun withEdges(candidates: List<Candidate<F>>): List<Candidate<F>> {
        val needed = maxOf(MIN_EDGES, robot.edges.size * 9 / 10)
        if (robot.edges.size < MIN_EDGES) return emptyList()
        return candidates.filter { (ClockFit.ofEdges(it.station.edges, robot.edges)?.edges ?: 0) >= needed }
    }

    /** Returns whether the edges of [candidate] fit the clocks if one of them is [ahead] s wrong. */
    private fun agrees(candidate: Candidate<F>, ahead: Double): Boolean {
        val byClocks = clocksOf(candidate.station) ?: return false
        val byEdges = ClockFit.ofEdges(candidate.station.edges, robot.edges, byClocks + ahead) ?: return false
        return byEdges.seconds - byClocks - ahead in -NEAR_CLOCKS..NEAR_CLOCKS
    }

    private fun agreesButForAnHour(candidate: Candidate<F>) = agrees(candidate, HOUR) || agrees(candidate, -HOUR)

    private fun clocksOf(station: ClockedLog): Double? = station.start?.let { start -> robot.start?.let { start - it } }

    /**
     * Returns how the clock of [station] relates to the robot's. It is by the moments of enabling, otherwise by the time of day; null if
     * neither shows it.
     */
    private fun fitOf(station: ClockedLog): ClockFit? {
        val byClocks = clocksOf(station)
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
        return begin < start + robot.last + HOUR && begin > start + robot.first - LONGEST
    }

    /** Returns the candidate that covers most of the time of the robot's log. */
    private fun byTime(candidates: List<Candidate<F>>): Candidate<F>? {
        val start = robot.start ?: return null
        fun common(candidate: Candidate<F>): Double = candidate.station.run {
            this.start?.let { minOf(start + robot.last, it + last) - maxOf(start + robot.first, it + first) } ?: 0.0
        }
        return candidates.filter { common(it) > 0 }.maxByOrNull(::common)
    }
}

/** The maximum number of logs that may begin before and during a robot's log. */
private const val MAX_AT_TIME = 16

/** The maximum length of a Driver Station log, in s. */
private const val LONGEST = 86_400.0

/** Clocks that are not set to daylight saving time are an hour off. */
private const val HOUR = 3600.0

/** A match has at least two: its start and its end. */
private const val MIN_EDGES = 2

/** The maximum difference between clocks that were set by each other, in s. */
private const val NEAR_CLOCKS = 5.0

/** Both clocks are known to the second. */
private const val CLOCK_ERROR = 1.0
