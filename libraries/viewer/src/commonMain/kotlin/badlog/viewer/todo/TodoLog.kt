package badlog.viewer.todo

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate

/**
 * A log of the folder with the findings of the rules.
 *
 * @property name the name of the log's file.
 * @property match the match in which the log was recorded.
 * @property second the time when the log began, in s since 1970 on the clock of the logs.
 * @property faults the findings.
 * @property isDated whether [second] can be compared with the clocks of other logs. The time of a file differs on each laptop, and a
 *   robot's clock in the future does not show which log is earlier.
 */
data class TodoLog(val name: String, val match: MatchOfLog, val second: Long, val faults: List<FoundFault>, val isDated: Boolean = true) {
    /** The displayed name: the match if known, otherwise the name of the file. */
    val title: String get() = match.match ?: name

    companion object {
        /**
         * Returns a log that began at [date] and has these [faults].
         *
         * @param now the local time of the wall clock here, in s since 1970 on that clock.
         */
        fun of(name: String, match: MatchOfLog, date: LogDate, now: Long, faults: List<FoundFault> = emptyList()): TodoLog {
            val isFuture = now > FIRST_RELEASE && date.second > now + DAY
            return TodoLog(name, match, date.second, faults, date.source != DateSource.FILE_TIME && !isFuture)
        }

        /** A day, in s: the time zone of a log may differ. */
        private const val DAY = 86_400L

        /** The beginning of 2025: a clock before it is wrong, and cannot recognize a date in the future. */
        private const val FIRST_RELEASE = 1_735_689_600L
    }
}

/**
 * A finding of a rule in a log.
 *
 * @property task the to-do item of the finding.
 * @property text the text of the finding, a sentence.
 */
data class FoundFault(val task: FaultTask, val severity: Severity, val text: String) {
    companion object {
        /** Returns [finding] as a possible item of a list. */
        fun of(finding: Finding): FoundFault = FoundFault(taskOf(finding), finding.severity, finding.text)
    }
}

/**
 * Returns the to-do item of [finding]. It is the same for the same fault in another match, and in the Driver Station's log, where topics
 * have other names.
 */
fun taskOf(finding: Finding): FaultTask = FaultTask(finding.rule, finding.topic.takeIf { finding.isForEach })
