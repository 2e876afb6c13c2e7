package badlog.viewer.todo

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.signals.match.MatchOfLog

/**
 * A log of the folder, with what rules found in it.
 *
 * @property name the name of its file.
 * @property match its match.
 * @property second when it began, in s since 1970 on the clock of the logs.
 * @property faults what was found.
 */
data class FoundLog(val name: String, val match: MatchOfLog, val second: Long, val faults: List<FoundFault>) {
    /** Its name for people: the match, or else the name of the file. */
    val title: String get() = match.match ?: name
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

/** Returns the item that [finding] is of: the same for the same fault in another match. */
fun taskOf(finding: Finding): FaultTask = FaultTask(finding.rule, finding.topic)
