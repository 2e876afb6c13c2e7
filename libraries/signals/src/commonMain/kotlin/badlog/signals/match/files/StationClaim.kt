package badlog.signals.match.files

import badlog.signals.clock.ALIKE
import badlog.signals.clock.CLEARER
import badlog.signals.clock.ClockFit
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.FoundStation
import badlog.signals.clock.batteryLikeness
import kotlin.math.abs

/**
 * The claim of a robot to a Driver Station's log.
 *
 * @property isOwn whether the log is of this robot rather than of another one in the same match; null if nothing shows that.
 * @property rivals the logs of other robots in that match.
 */
class StationClaim(val isOwn: Boolean?, val rivals: List<ClockedLog>)

/**
 * Returns the claim of [robot], for which this log was found.
 *
 * Two robots in one match are enabled at the same moments. Only the battery voltage, which both robot and Driver Station log, tells them apart.
 *
 * @param others other logs that may be of a robot in the same match; also earlier or later ones of [robot] itself.
 */
fun FoundStation<*>.claimOf(robot: ClockedLog, others: List<ClockedLog>): StationClaim {
    val rivals = others.mapNotNull { other -> rivalFit(robot, other)?.let { other to it } }
    if (rivals.isEmpty()) return StationClaim(true, emptyList())
    val own = batteryLikeness(station, robot, fit.seconds)
    val best = rivals.mapNotNull { (other, fit) -> batteryLikeness(station, other, fit.seconds) }.maxOrNull()
    val isOwn = when {
        own != null && own >= ALIKE -> true
        own != null && best != null && best >= ALIKE && best - own >= CLEARER -> false
        else -> null
    }
    return StationClaim(isOwn, rivals.map { it.first })
}

/** Returns the relation of the clocks of this log and [other]; null unless [other] is of another robot in the same match. */
private fun FoundStation<*>.rivalFit(robot: ClockedLog, other: ClockedLog): ClockFit? {
    val its = ClockFit.ofEdges(station.edges, other.edges, clocksOf(station, other))?.takeIf { it.edges >= MIN_EDGES } ?: return null
    // A robot has one clock for all of its logs, unless its program was restarted; then they are not of the same time.
    if (abs(its.seconds - fit.seconds) < SAME_CLOCK) return null
    val common = minOf(robot.last - fit.seconds, other.last - its.seconds) - maxOf(robot.first - fit.seconds, other.first - its.seconds)
    // A coprocessor logs other topics, and no battery.
    val isRobot = areAlike(robot.recording, other.recording) || batteryLikeness(station, other, its.seconds) != null
    return its.takeIf { common > MIN_COMMON && isRobot }
}

/** In s. */
private const val SAME_CLOCK = 0.1

/** In s: logs of two robots in a match have more time in common. */
private const val MIN_COMMON = 10.0
