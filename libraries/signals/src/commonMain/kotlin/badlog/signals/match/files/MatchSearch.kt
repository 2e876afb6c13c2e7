package badlog.signals.match.files

import badlog.signals.clock.ClockFit
import badlog.signals.clock.StationSearch
import badlog.signals.clock.batteryFit
import badlog.signals.clock.motorFit
import badlog.signals.match.NaturalOrder
import badlog.signals.match.isSameAs

/**
 * Returns the matches among [files]. Each is a robot's log with the files that fit only this match.
 *
 * A file with a stated clock belongs to the match. Any other file is excluded if its number or type of match contradicts. Among the rest, a
 * file is taken if its clock fits by the moments of enabling or of driven motors, or by the battery voltage, and if the time of day or the
 * number of the match shows the same match: all matches have the same periods. Doubtful files are in no match. The order of [files] makes
 * no difference.
 */
fun matchesOf(files: List<MatchFile>): FoundMatches {
    val sorted = files.sortedWith(compareBy<MatchFile> { it.role }.thenBy(::rankOf).thenBy(NaturalOrder) { it.name })
    val (timed, timeless) = sorted.partition { it.log.hasClock }
    val left = ArrayList(timeless.map { it to "${it.name} has no samples over time, so it cannot be placed." })
    val ofRobots = timed.filter { it.role == FileRole.ROBOT }
    // A log that does not show when the robot was enabled, such as a camera's, is put beside one that does.
    val leading = ofRobots.filter { it.log.edges.isNotEmpty() || it.seconds != null }.ifEmpty { ofRobots }
    val groups = RobotGroups(leading).groups
    if (groups.isEmpty()) {
        return FoundMatches(emptyList(), left + timed.map { it to "${it.name} is without the log of a robot; a match begins with one." })
    }
    val found = groups.map { it.toMutableList() }
    val robots = groups.map { it.first().file }
    val others = timed - leading.toSet()
    for (file in others.filter { it.seconds != null }) {
        val home = homeOf(file, robots)
        if (home == null) left += file to doubt(file, robots) else found[home] += file.statedBeside(robots[home])
    }
    val open = others.filter { it.seconds == null }
    val (stations, logs) = open.partition { it.role == FileRole.STATION }
    val shown = found.map { parts -> parts.filter { it.file.role == FileRole.ROBOT } }
    stationsOf(shown, stations, found.map { parts -> parts.any { it.file.role == FileRole.STATION } }, left)
        .forEachIndexed { i, part -> part?.let { found[i] += it } }
    for (file in logs) {
        val fits = shown.map { parts -> fitOf(file, parts) }
        val only = fits.indices.filter { fits[it]?.isSure == true }.singleOrNull()
        if (only != null) found[only] += checkNotNull(fits[only]).part else left += file to reasonFor(file, robots, fits)
    }
    return FoundMatches(found.map { parts -> OneMatch(parts, missingIn(parts, left.map { it.first }) + doubtsIn(parts)) }, left)
}

/** The log that is stated to have the clock of the match comes first, then others with a stated clock. */
private fun rankOf(file: MatchFile) = if (file.seconds == 0.0) {
    0
} else if (file.seconds != null) {
    1
} else {
    2
}

/** Returns the place that is stated for this file, on the clock of [robot]. */
internal fun MatchFile.statedBeside(robot: MatchFile): MatchPart =
    MatchPart(this, checkNotNull(seconds) - (robot.seconds ?: 0.0), ClockReason.STATED, error)

/** Returns which of [robots] the stated clock of [file] refers to; null if that is open. */
private fun homeOf(file: MatchFile, robots: List<MatchFile>): Int? = robots.indices.singleOrNull { robots[it].seconds != null }
    ?: robots.indices.singleOrNull()
    ?: robots.indices.singleOrNull { file.log.match.isSameAs(robots[it].log.match) == true }

/** A place for a file in a match; doubtful unless [isSure]. */
private class PossiblePart(val part: MatchPart, val isSure: Boolean, val contradicts: Boolean)

/** Returns the surest of these places, beside the logs of one robot; of several, that with the clearest reason. */
private fun List<PossiblePart>.best(): PossiblePart? =
    minWithOrNull(compareBy<PossiblePart> { !it.isSure }.thenBy { it.part.reason }.thenByDescending { it.part.edges })

/** A number or type of match that contradicts excludes a file, whichever of [robots] has it. */
private fun isOfAnother(file: MatchFile, robots: List<MatchPart>) = robots.any { file.log.match.isSameAs(it.file.log.match) == false }

/** Returns [file] on the clock of the match. [seconds] and their [error] put it on the clock of this log. */
private fun MatchPart.placed(file: MatchFile, seconds: Double, reason: ClockReason, error: Double? = null, edges: Int = 0): MatchPart =
    MatchPart(file, this.seconds + seconds, reason, error?.let { it + (this.error ?: 0.0) }, edges)

/**
 * Returns the Driver Station's log of its match, or null, for each of [robots] that does not [have][haveOne] one. Each robot has all its
 * logs. [stations] that are in no match are added to [left].
 */
private fun stationsOf(
    robots: List<List<MatchPart>>,
    stations: List<MatchFile>,
    haveOne: List<Boolean>,
    left: MutableList<Pair<MatchFile, String>>,
): List<MatchPart?> {
    val areAlone = robots.size == 1 && stations.size == 1
    val found = robots.mapIndexed { i, robot -> if (haveOne[i]) null else stationOf(robot, stations, areAlone) }
    for (station in stations) {
        val claims = robots.indices.filter { found[it]?.part?.file === station }
        if (claims.size == 1 && found[claims[0]]?.isSure == true) continue
        left += station to reasonFor(station, robots.map { it.first().file }, found.map { it?.takeIf { one -> one.part.file === station } })
    }
    return found.map { one -> one?.part?.takeIf { one.isSure && found.count { it?.part?.file === one.part.file } == 1 } }
}

private fun stationOf(robots: List<MatchPart>, stations: List<MatchFile>, areAlone: Boolean): PossiblePart? {
    val open = stations.filterNot { isOfAnother(it, robots) }
    // Of several logs of a robot, one may show when it was enabled, and another the time of day.
    return robots.mapNotNull { robot ->
        val pair = StationSearch<MatchFile>(robot.file.log, { it.log.start }, { it.log }).over(open) ?: return@mapNotNull null
        val reason = if (pair.fit.edges > 0) ClockReason.ENABLED else ClockReason.SYSTEM_TIME
        val part = robot.placed(pair.log, pair.fit.seconds, reason, pair.fit.error, pair.fit.edges)
        PlaceEvidence(pair.log, part.seconds, robots).run {
            // A single edge may be of any match. All matches have the same periods, and a replay has the same number.
            val isSure = !contradicts && if (pair.fit.edges < MIN_EDGES) isSame && agrees else isSame || agrees || areAlone
            PossiblePart(part, isSure, contradicts)
        }
    }.best()
}

/** Returns the place of [file], a log of devices, beside [robots]. Null if nothing shows it, or the match is another one. */
private fun fitOf(file: MatchFile, robots: List<MatchPart>): PossiblePart? =
    if (isOfAnother(file, robots)) null else robots.mapNotNull { fitOf(file, it, robots) }.best()

private fun fitOf(file: MatchFile, robot: MatchPart, robots: List<MatchPart>): PossiblePart? {
    val (own, others) = file.log to robot.file.log
    val byClocks = clocksOf(own, others)
    fun part(fit: ClockFit, reason: ClockReason): PossiblePart {
        val part = robot.placed(file, fit.seconds, reason, fit.error, fit.edges)
        return PlaceEvidence(file, part.seconds, robots).run { PossiblePart(part, !contradicts && (agrees || isSame), contradicts) }
    }
    ClockFit.ofEdges(own.edges, others.edges, byClocks)?.takeIf { it.edges >= MIN_EDGES }?.let { return part(it, ClockReason.ENABLED) }
    motorFit(own.view, others.view, others.vocabulary)?.let { return part(it, ClockReason.MOTORS) }
    batteryFit(own, others)?.let { return part(it, ClockReason.BATTERY) }
    if (byClocks == null) return null
    val isDuring = own.first + byClocks < others.last && own.last + byClocks > others.first
    val part = robot.placed(file, byClocks, ClockReason.SYSTEM_TIME)
    return PlaceEvidence(file, part.seconds, robots).run {
        PossiblePart(part, isDuring && isSame && !contradicts, !isDuring || contradicts).takeIf { isDuring || isSame }
    }
}

private fun reasonFor(file: MatchFile, robots: List<MatchFile>, fits: List<PossiblePart?>): String {
    val possible = robots.indices.filter { fits[it] != null }
    if (possible.size > 1) return doubt(file, possible.map { robots[it] })
    val one = possible.singleOrNull()?.let { robots[it] to checkNotNull(fits[it]) } ?: return fitsNone(file)
    val (robot, fit) = one
    val why = if (fit.contradicts) "but the time of day contradicts" else "but neither the time of day nor the number of the match shows it"
    return "${file.name} may be of the match of ${robot.name} (${fit.part.why}), $why; if it is, state its clock in a match.json."
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

/** Returns a sentence about each Driver Station's log of [parts] that nothing but its edges places there. */
private fun doubtsIn(parts: List<MatchPart>): List<String> {
    val robots = parts.filter { it.file.role == FileRole.ROBOT }.map { it.file.log }
    return parts.filter { part ->
        part.file.role == FileRole.STATION && part.reason != ClockReason.STATED &&
            robots.all { part.file.log.match.isSameAs(it.match) != true && clocksOf(part.file.log, it) == null }
    }.map {
        "${it.file.name} fits by when the robot was enabled, but neither the time of day nor the number shows that it is of this match."
    }
}

/** The fewest moments that show where a log belongs: the start and the end of a period. */
internal const val MIN_EDGES = 2
