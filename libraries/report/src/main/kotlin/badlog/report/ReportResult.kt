package badlog.report

import badlog.catalog.examine.UndefinedTopic
import badlog.core.recording.Severity
import badlog.files.LogFile
import badlog.rules.Finding
import badlog.rules.NotLookedAt
import badlog.rules.SkippedRule
import badlog.rules.comparison.LogDifferences
import badlog.rules.incident.Incident
import badlog.rules.number.LogNumbers
import badlog.signals.battery.BatteryUse
import badlog.signals.match.MatchOfLog

/**
 * The findings in many logs.
 *
 * @property logs all files, in the given order.
 * @property skipped the rules that were skipped for some logs, in the order of the rules.
 */
class ReportResult internal constructor(val logs: List<LogReport>, val skipped: List<SkippedRule>) {
    /** The batteries in the logs. */
    val batteries: SeasonOfLogs by lazy { SeasonOfLogs.of(logs) }

    /** Returns the number of findings of [severity]. */
    fun count(severity: Severity): Int = logs.sumOf { log -> log.findings.count { it.severity == severity } }
}

/**
 * The findings in one log.
 *
 * @property file the file.
 * @property title the match, from the log or its file's name; null if neither has it, or the file cannot be read.
 * @property matchType the type of the match, such as `Qualification`, from the log or its file's name; null if neither has it.
 * @property match the match, from the log or its file's name; from the name alone if the file cannot be read.
 * @property began the local time of its beginning, in s since 1970, from the log or its file's name; null if neither has it.
 * @property findings the findings, the worst first; see `worstFirst`.
 * @property incidents the findings that belong together, causes before effects; the worst incident first.
 * @property skipped the rules that were skipped for it, in the order of the rules; a rule with a mistake here may be valid for another log.
 * @property unreadable why the file cannot be read or is not a log, as a sentence; null if it could be read.
 * @property isNoLog whether it is [unreadable] because it is not a log.
 * @property isSalvaged whether part of the log is lost, so that the findings cover only the rest.
 * @property undefined the virtual topics that could not be calculated.
 * @property hookFailures the hooks that failed for it.
 * @property numbers numbers that summarize all of it, such as the resistance of its battery.
 * @property differences its differences from the other logs of the report.
 * @property battery its data about the robot's battery; null if it has none.
 */
class LogReport internal constructor(
    val file: LogFile,
    val title: String?,
    val matchType: String?,
    val match: MatchOfLog,
    val began: Long?,
    val findings: List<Finding>,
    val incidents: List<Incident>,
    val skipped: List<SkippedRule>,
    val unreadable: String?,
    val isNoLog: Boolean,
    val isSalvaged: Boolean,
    val undefined: List<UndefinedTopic>,
    val hookFailures: List<HookFailure>,
    val numbers: LogNumbers = LogNumbers.NONE,
    val differences: LogDifferences = LogDifferences.NONE,
    val battery: BatteryUse? = null,
    private val ran: Int = 0,
) {
    /** The number of rules that ran, and the signals missing for the others. */
    val notLookedAt: NotLookedAt get() = NotLookedAt(ran, skipped)
}

/**
 * A hook that failed for a log.
 *
 * @property hook its name.
 * @property message the error, as a sentence.
 */
class HookFailure internal constructor(val hook: String, val message: String)
