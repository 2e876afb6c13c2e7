package badlog.report

import badlog.file.LogFile
import badlog.recording.Severity
import badlog.rules.Finding
import badlog.rules.SkippedRule
import badlog.rules.comparison.LogDifferences
import badlog.rules.figure.LogFigures
import badlog.rules.incident.Incident

/**
 * What was found in many logs.
 *
 * @property logs every file, in the order in which they were given.
 * @property skipped the rules that were skipped for some logs, in the order of the rules.
 */
public class ReportResult internal constructor(public val logs: List<LogReport>, public val skipped: List<SkippedRule>) {
    /** How many findings there are of [severity]. */
    public fun count(severity: Severity): Int = logs.sumOf { log -> log.findings.count { it.severity == severity } }
}

/**
 * What was found in one log.
 *
 * @property file the file.
 * @property title what match it is, from its values; null when they do not say or it cannot be read.
 * @property matchType the type of the match in its words, such as `Qualification`; null when the log does not say.
 * @property findings the worst first, and of one severity in the order of time.
 * @property incidents which of them belong together, and what came first; the worst first.
 * @property skipped the rules that were skipped for it, in the order of the rules; one that is a mistake here may be right for
 *   another log.
 * @property unreadable why the file cannot be read or is not a log, as a sentence; null when all is well.
 * @property isNoLog whether it is [unreadable] because it is something else than a log.
 * @property isSalvaged whether the log lost something, so that the findings are about what is left.
 * @property undefined the virtual topics that the log could not be given.
 * @property hookFailures the hooks that failed for it.
 * @property figures numbers that say something of all of it, such as the resistance of its battery.
 * @property differences what was different in it from the others of the report.
 */
public class LogReport internal constructor(
    public val file: LogFile,
    public val title: String?,
    public val matchType: String?,
    public val findings: List<Finding>,
    public val incidents: List<Incident>,
    public val skipped: List<SkippedRule>,
    public val unreadable: String?,
    public val isNoLog: Boolean,
    public val isSalvaged: Boolean,
    public val undefined: List<UndefinedTopic>,
    public val hookFailures: List<HookFailure>,
    public val figures: LogFigures = LogFigures.NONE,
    public val differences: LogDifferences = LogDifferences.NONE,
)

/**
 * A hook that failed for a log.
 *
 * @property hook what it is called.
 * @property message what went wrong, as a sentence.
 */
public class HookFailure internal constructor(public val hook: String, public val message: String)
