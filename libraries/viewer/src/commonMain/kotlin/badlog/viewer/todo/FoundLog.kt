package badlog.viewer.todo

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate

/**
 * A log of the folder, with what rules found in it.
 *
 * @property name the name of its file.
 * @property match its match.
 * @property second when it began, in s since 1970 on the clock of the logs.
 * @property faults what was found.
 * @property isDated whether [second] can be compared with the clocks of other logs. The time of a file differs on each laptop, and a robot whose
 * clock is in the future says nothing about what is earlier.
 */
data class FoundLog(val name: String, val match: MatchOfLog, val second: Long, val faults: List<FoundFault>, val isDated: Boolean = true) {
    /** Its name for people: the match, or else the name of the file. */
    val title: String get() = match.match ?: name

    companion object {
        /**
         * Returns a log that began at [date], in which [faults] were found.
         *
         * @param now the time on a clock on the wall here, in s since 1970 on that clock.
         */
        fun of(name: String, match: MatchOfLog, date: LogDate, now: Long, faults: List<FoundFault> = emptyList()): FoundLog {
            val isFuture = now > FIRST_RELEASE && date.second > now + DAY
            return FoundLog(name, match, date.second, faults, date.source != DateSource.FILE_TIME && !isFuture)
        }

        /** The time zone of a log may be another one. */
        private const val DAY = 86_400L

        /** The begin of 2025: a laptop whose clock is before it does not know what the future is. */
        private const val FIRST_RELEASE = 1_735_689_600L
    }
}

/**
 * What a rule found in a log.
 *
 * @property task what it is about.
 * @property text what was found, as a sentence.
 */
data class FoundFault(val task: FaultTask, val severity: Severity, val text: String) {
    companion object {
        /** Returns [finding] as what may be on a list. */
        fun of(finding: Finding): FoundFault = FoundFault(taskOf(finding), finding.severity, finding.text)
    }
}

/**
 * Returns the item that [finding] is of: the same for the same fault in another match, and in the Driver Station's log, whose topics have other
 * names.
 */
fun taskOf(finding: Finding): FaultTask = FaultTask(finding.rule, finding.topic.takeIf { finding.isForEach })
