package badlog.signals.match.files

import badlog.signals.clock.ClockFit
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.StationSearch
import badlog.signals.clock.batteryFit
import badlog.signals.clock.motorFit
import badlog.signals.match.NaturalOrder
import badlog.signals.match.isSameAs
import badlog.signals.match.matchInName
import kotlin.math.abs

/**
 * Returns which of [files] belong to one match: each log of a robot is one, with the files that fit it alone.
 *
 * A number or type of match that contradicts excludes a file. Among the others, the moments of enabling or of driven motors decide, then
 * the battery voltage, then the clocks. A file that fits two matches alike is in neither. The order of [files] makes no difference.
 */
fun matchesOf(files: List<MatchFile>): FoundMatches {
    val sorted = files.sortedWith(compareBy<MatchFile> { it.role }.thenBy { it.seconds != 0.0 }.thenBy(NaturalOrder) { it.name })
    val left = ArrayList<Pair<MatchFile, String>>()
    val ofRobots = sorted.filter { it.role == FileRole.ROBOT && it.log != null }
    // A log that does not show when the robot was enabled, such as a camera's, is put beside one that does.
    val leading = ofRobots.filter { it.log?.edges?.isNotEmpty() == true || it.seconds != null }.ifEmpty { ofRobots }
    val groups = RobotGroups(leading).groups
    if (groups.isEmpty()) {
        sorted.mapTo(left) { it to "${it.name} is without the log of a robot; a match begins with one." }
        return FoundMatches(emptyList(), left)
    }
    val found = groups.map { it.toMutableList() }
    val robots = groups.map { it.first().file }
    stationsOf(robots, sorted.filter { it.role == FileRole.STATION }, left).forEachIndexed { i, part -> part?.let { found[i] += it } }
    for (file in (ofRobots - leading.toSet()) + sorted.filter { it.role > FileRole.STATION }) {
        val fits = robots.map { if (file.log == null) videoOf(file, it, robots.size) else fitOf(file, it, robots.size == 1) }
        val sure = fits.indices.filter { fits[it]?.isSure == true }
        val only = sure.singleOrNull() ?: sure.filter { isNamed(file, robots[it]) }.singleOrNull()
        if (only != null) found[only] += checkNotNull(fits[only]).part else left += file to reasonFor(file, robots, fits.map { it?.part })
    }
    return FoundMatches(found.map { parts -> OneMatch(parts, missingIn(parts, left.map { it.first })) }, left)
}

/** A place for a file in a match; doubtful unless [isSure]. */
private class PossiblePart(val part: MatchPart, val isSure: Boolean)

/** Returns for each of [robots] the Driver Station's log of its match, or null; those in no match are added to [left]. */
private fun stationsOf(robots: List<MatchFile>, stations: List<MatchFile>, left: MutableList<Pair<MatchFile, String>>): List<MatchPart?> {
    val stated = stations.filter { it.seconds != null }
    val found = robots.map { robot ->
        if (stated.isNotEmpty() && robots.size == 1) {
            return@map MatchPart(stated.first(), checkNotNull(stated.first().seconds), ClockReason.STATED, stated.first().error)
        }
        val log = robot.log ?: return@map null
        StationSearch<MatchFile>(log, { it.log?.start }, { it.log }).over(stations)?.let { pair ->
            val reason = if (pair.fit.edges > 0) ClockReason.ENABLED else ClockReason.SYSTEM_TIME
            MatchPart(pair.log, pair.fit.seconds, reason, pair.fit.error, pair.fit.edges)
        }
    }
    val claims = robots.indices.filter { found[it] != null }.groupBy { found[it]!!.file }
    val doubtful = claims.filterValues { it.size > 1 }.mapValues { (station, all) -> all.filterNot { isNamed(station, robots[it]) } }
    for (station in stations) {
        val all = claims[station].orEmpty()
        val kept = all - doubtful[station].orEmpty().toSet()
        if (all.isEmpty()) {
            left += station to fitsNone(station)
        } else if (all.size > 1 && kept.size != 1) {
            left += station to doubt(station, all.map { robots[it] })
        }
    }
    return found.mapIndexed { i, part ->
        val all = part?.let { claims.getValue(it.file) }.orEmpty()
        val kept = part?.let { all - doubtful[it.file].orEmpty().toSet() }.orEmpty()
        part?.takeIf { all.size == 1 || kept == listOf(i) }
    }
}

/** Whether both [file] and [robot] name the same match. */
private fun isNamed(file: MatchFile, robot: MatchFile): Boolean = matchOf(file).isSameAs(matchOf(robot)) == true

private fun matchOf(file: MatchFile) = file.log?.match ?: matchInName(file.name)

/** Returns the place of [file], a log of devices, beside [robot]; null if nothing shows it, or the match is another one. */
private fun fitOf(file: MatchFile, robot: MatchFile, isOnly: Boolean): PossiblePart? {
    val (own, others) = (file.log ?: return null) to (robot.log ?: return null)
    file.seconds?.let { return PossiblePart(MatchPart(file, it, ClockReason.STATED, file.error), isOnly || isNamed(file, robot)) }
    val isSame = matchOf(file).isSameAs(matchOf(robot))
    if (isSame == false) return null
    val byClocks = clocksOf(own, others)
    fun part(fit: ClockFit, reason: ClockReason): PossiblePart {
        val agrees = byClocks != null && OFF.any { abs(fit.seconds - byClocks - it) <= NEAR }
        val contradicts = byClocks != null && !agrees
        val isSure = agrees || (!contradicts && (isSame == true || isOnly))
        return PossiblePart(MatchPart(file, fit.seconds, reason, fit.error, fit.edges), isSure)
    }
    ClockFit.ofEdges(own.edges, others.edges, byClocks)?.takeIf { it.edges >= FEWEST }?.let { return part(it, ClockReason.ENABLED) }
    motorFit(own.view, others.view, others.vocabulary)?.let { return part(it, ClockReason.MOTORS) }
    batteryFit(own, others)?.let { return part(it, ClockReason.BATTERY) }
    if (byClocks != null) {
        val isDuring = own.first + byClocks < others.last && own.last + byClocks > others.first
        return PossiblePart(MatchPart(file, byClocks, ClockReason.SYSTEM_TIME, CLOCK_ERROR), isDuring).takeIf { isDuring || isSame == true }
    }
    val fromStart = MatchPart(file, 0.0, ClockReason.PROGRAM_START)
    return if (file.role == FileRole.MOTORS) PossiblePart(fromStart, isOnly || isSame == true) else null
}

/** Returns the place of the video [file], which is found by its name alone. */
private fun videoOf(file: MatchFile, robot: MatchFile, count: Int): PossiblePart? {
    val isSame = matchOf(file).isSameAs(matchOf(robot))
    val reason = if (file.seconds == null) ClockReason.OWN else ClockReason.STATED
    if (isSame == false) return null
    return PossiblePart(MatchPart(file, file.seconds ?: 0.0, reason, file.error), isSame == true || count == 1)
}

private fun clocksOf(own: ClockedLog, others: ClockedLog): Double? = own.start?.let { start -> others.start?.let { start - it } }

private fun reasonFor(file: MatchFile, robots: List<MatchFile>, fits: List<MatchPart?>): String {
    val possible = robots.indices.filter { fits[it] != null }
    if (possible.size > 1) return doubt(file, possible.map { robots[it] })
    val one = possible.singleOrNull() ?: return fitsNone(file)
    return "${file.name} may be of the match of ${robots[one].name} (${checkNotNull(fits[one]).why}), but its clock contradicts; if it is, " +
        "state its clock in a match.json."
}

private fun fitsNone(file: MatchFile): String =
    "${file.name} fits none of the robots' logs; if it is of one of these matches, state its clock in a match.json."

private fun doubt(file: MatchFile, robots: List<MatchFile>): String =
    "${file.name} may be of ${robots.joinToString(" or ") { it.name }}; state its clock in the match.json of the right match."

private fun missingIn(parts: List<MatchPart>, left: List<MatchFile>): List<String> = buildList {
    if (parts.none { it.file.role == FileRole.STATION } && left.none { it.role == FileRole.STATION }) {
        add("The Driver Station's log is missing; it is on the laptop that drove.")
    }
}

/** In s: clocks are right, or an hour off, as with daylight saving time. */
private val OFF = listOf(0.0, 3600.0, -3600.0)
private const val NEAR = 5.0
private const val FEWEST = 2
private const val CLOCK_ERROR = 1.0
