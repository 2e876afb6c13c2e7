package badlog.report.rules

import badlog.analysis.LogView
import badlog.report.SkippedRule

/**
 * What rules say of one log.
 *
 * @property findings in the order of the rules.
 * @property skipped the rules that could not be asked, in their order.
 */
public class LogFindings(public val findings: List<Finding>, public val skipped: List<SkippedRule>)

/**
 * Runs these rules over [view], which was read from a file called [file].
 *
 * @throws InterruptedException when the thread was interrupted; looked at between two rules.
 */
public fun RuleSet.over(view: LogView, file: String): LogFindings {
    val findings = ArrayList<Finding>()
    val skipped = ArrayList<SkippedRule>()
    RuleRunner(this).run(view, view.title ?: file, file, { findings += it }) { rule, refusal ->
        if (Thread.interrupted()) throw InterruptedException()
        if (refusal != null) {
            skipped += SkippedRule(rule.name, logs = 1, refusal.mistake ?: refusal.message, isMistake = refusal.mistake != null)
        }
    }
    return LogFindings(findings, skipped)
}
