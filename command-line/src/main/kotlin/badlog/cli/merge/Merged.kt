package badlog.cli.merge

import badlog.recording.Recording

/**
 * One recording, made of several.
 *
 * @property recording what holds all of them.
 * @property groups the logs that stand side by side; those of one group one after the other.
 * @property renamed what is called otherwise than in its log.
 */
internal class Merged(val recording: Recording, val groups: List<Group>, val renamed: List<Renaming>) {
    /**
     * Logs that follow each other.
     *
     * @property parts the logs, in the order in which they begin.
     * @property repeated how many rows, or samples, were left out because another log has them, too.
     */
    class Group(val parts: List<LogPart>, val repeated: Int) {
        /** Where two that follow each other both have rows, or samples. */
        val overlaps: List<Overlap>
            get() = parts.zipWithNext { one, other ->
                if (other.firstX <= one.lastX) Overlap(one, other, other.firstX, minOf(one.lastX, other.lastX)) else null
            }.filterNotNull().filter { it.one.xTopic != null || !it.one.hasRows }
    }
}

/** A stretch of x, [from] until [to], in which both [one] and [other] have rows. */
internal class Overlap(val one: LogPart, val other: LogPart, val from: Double, val to: Double)
