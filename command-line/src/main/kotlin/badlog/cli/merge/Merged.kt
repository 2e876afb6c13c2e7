package badlog.cli.merge

import badlog.core.recording.Recording

/**
 * One recording made from several.
 *
 * @property recording the recording of all logs.
 * @property groups the groups of logs that are side by side; those in one group follow each other.
 * @property renamed the topics and values that have another name in their log.
 */
internal class Merged(val recording: Recording, val groups: List<Group>, val renamed: List<Renaming>) {
    /**
     * Logs that follow each other.
     *
     * @property parts the logs, in the order in which they begin.
     * @property repeated the number of rows, or samples, skipped because another log also has them.
     */
    class Group(val parts: List<LogPart>, val repeated: Int) {
        /** The ranges of x in which two consecutive logs both have rows, or samples. */
        val overlaps: List<Overlap>
            get() = parts.zipWithNext { one, other ->
                if (other.firstX <= one.lastX) Overlap(one, other, other.firstX, minOf(one.lastX, other.lastX)) else null
            }.filterNotNull().filter { it.one.xTopic != null || !it.one.hasRows }
    }
}

/** A range of x, [from] until [to], in which both [one] and [other] have rows. */
internal class Overlap(val one: LogPart, val other: LogPart, val from: Double, val to: Double)
