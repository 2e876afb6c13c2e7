package badlog.signals.match.files

import badlog.signals.clock.ClockedLog
import badlog.signals.match.isSameAs
import kotlin.math.abs

/** The evidence in [robots], all logs of one robot, about [file], moved by [seconds] s to the match's clock. */
internal class PlaceEvidence(file: MatchFile, seconds: Double, robots: List<MatchPart>) {
    private val clocks = robots.mapNotNull { robot -> clocksOf(file.log, robot.file.log)?.let { agree(seconds - robot.seconds, it) } }

    /** Whether the number of the match is the same. */
    val isSame: Boolean = robots.any { file.log.match.isSameAs(it.file.log.match) == true }

    /** Whether the time of day is the same in all logs that show it. */
    val agrees: Boolean = clocks.isNotEmpty() && clocks.all { it }

    /** Whether any log shows another time of day. */
    val contradicts: Boolean = clocks.any { !it }
}

/** Returns the offset to add to the times of [own] for the clock of [others], by the time of day, in s. Null if one does not show it. */
internal fun clocksOf(own: ClockedLog, others: ClockedLog): Double? = own.start?.let { start -> others.start?.let { start - it } }

/** Whether [seconds] agrees with the clocks, [byClocks], or is an hour off, as with daylight saving time. */
private fun agree(seconds: Double, byClocks: Double) = OFF.any { areNear(seconds - it, byClocks) }

/** Returns whether two offsets between clocks, in s, are close enough for clocks that were set by each other. */
internal fun areNear(one: Double, other: Double): Boolean = abs(one - other) <= NEAR

/** In s: clocks are right, or an hour off. */
private val OFF = listOf(0.0, 3600.0, -3600.0)
private const val NEAR = 5.0
