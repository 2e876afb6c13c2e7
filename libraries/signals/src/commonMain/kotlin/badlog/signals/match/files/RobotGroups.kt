package badlog.signals.match.files

import badlog.core.recording.Recording
import badlog.signals.clock.ClockFit
import badlog.signals.match.isSameAs

/**
 * Robots' logs, grouped by robot and match. A robot may write several at once, such as a bag and a WPILOG.
 *
 * @param files the logs, in order; those with a stated clock first.
 */
internal class RobotGroups(files: List<MatchFile>) {
    /** The logs of each match, on the clock of the first. */
    val groups: List<List<MatchPart>>

    init {
        val made = ArrayList<MutableList<MatchPart>>()
        for (file in files) {
            val only = made.mapNotNull { group -> besideOf(file, group.first().file)?.let { group to it } }.singleOrNull()
            if (only == null) made += mutableListOf(MatchPart(file, 0.0, ClockReason.OWN)) else only.first += only.second
        }
        groups = made
    }

    /** Returns the place of [file] beside [first]. Null if it is the log of another match, or of another robot in the same one. */
    private fun besideOf(file: MatchFile, first: MatchFile): MatchPart? {
        if (file.seconds != null && first.seconds != null) return file.statedBeside(first)
        val isSame = file.log.match.isSameAs(first.log.match)
        if (isSame == false || areAlike(file.log.recording, first.log.recording)) return null
        val byClocks = clocksOf(file.log, first.log)
        val fit = ClockFit.ofEdges(file.log.edges, first.log.edges, byClocks)?.takeIf { it.edges >= MIN_EDGES } ?: return null
        // Every match has the same periods, and one robot has one clock.
        val isSure = if (byClocks == null) isSame == true else areNear(fit.seconds, byClocks)
        return if (isSure) MatchPart(file, fit.seconds, ClockReason.ENABLED, fit.error, fit.edges) else null
    }
}

/**
 * Returns whether the logs [one] and [other] have nearly the same topics, as two robots with one program do. A coprocessor may log a few of
 * its robot's topics.
 */
internal fun areAlike(one: Recording, other: Recording): Boolean {
    val (names, others) = namesIn(one) to namesIn(other)
    return names == others || names.count { it in others } * 2 >= maxOf(names.size, others.size)
}

/** The names of topics, without those that each log of WPILib has. */
private fun namesIn(log: Recording): Set<String> =
    log.topics.map { it.name }.filterNotTo(HashSet()) { name -> EVERYWHERE.any { it in name } }

private val EVERYWHERE = listOf("DS:", "FMSInfo", "systemTime", "messages", "/.schema/")
