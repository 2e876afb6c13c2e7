package badlog.signals.match.files

import badlog.signals.clock.ClockFit
import badlog.signals.clock.ClockedLog
import badlog.signals.match.isSameAs
import kotlin.math.abs

/**
 * Robots' logs, those of one robot and match together: a robot may write several at once, such as a bag and a WPILOG.
 *
 * @param files the logs, in order.
 */
internal class RobotGroups(files: List<MatchFile>) {
    /** The logs of each match, on the clock of the first. */
    val groups: List<List<MatchPart>>

    init {
        val made = ArrayList<MutableList<MatchPart>>()
        for (file in files) {
            val fits = made.mapNotNull { group -> besideOf(file, group.first().file, files.size)?.let { group to it } }
            val only = fits.singleOrNull()
            if (only == null) made += mutableListOf(MatchPart(file, 0.0, ClockReason.OWN)) else only.first += only.second
        }
        groups = made
    }

    /** Returns the place of [file] beside [first]; null if it is the log of another match, or of another robot in the same one. */
    private fun besideOf(file: MatchFile, first: MatchFile, count: Int): MatchPart? {
        val (own, others) = (file.log ?: return null) to (first.log ?: return null)
        if (own.match.isSameAs(others.match) == false) return null
        file.seconds?.let { return MatchPart(file, it, ClockReason.STATED, file.error) }
        // Two robots with one program log the same topics; one robot does not log them twice.
        if (namesOf(own) == namesOf(others)) return null
        val byClocks = own.start?.let { start -> others.start?.let { start - it } }
        val fit = ClockFit.ofEdges(own.edges, others.edges, byClocks)?.takeIf { it.edges >= FEWEST } ?: return null
        // Every match has the same periods, so that edges alone do not tell which it is.
        val agrees = byClocks?.let { abs(fit.seconds - it) <= NEAR }
        val isSure = agrees ?: (count == 2)
        return if (isSure) MatchPart(file, fit.seconds, ClockReason.ENABLED, fit.error, fit.edges) else null
    }

    private fun namesOf(log: ClockedLog) = log.recording.topics.mapTo(HashSet()) { it.name }

    private companion object {
        const val FEWEST = 2

        /** In s: one robot has one clock. */
        const val NEAR = 5.0
    }
}
