package badlog.rules

import badlog.analysis.LogView

/**
 * What rules say of one log.
 *
 * @property findings in the order of the rules.
 * @property skipped the rules that were skipped, in their order.
 */
public class LogFindings(public val findings: List<Finding>, public val skipped: List<SkippedRule>)

/**
 * A rule that was skipped, mostly because a log lacks its topics.
 *
 * @property rule its name.
 * @property logs for how many logs.
 * @property message why, in the first of them.
 * @property isMistake whether the rule itself is wrong; [message] then points at the mistake in the file of rules.
 */
public class SkippedRule(public val rule: String, public val logs: Int, public val message: String, public val isMistake: Boolean) {
    /** As a sentence, or more where the rule is wrong. */
    override fun toString(): String = if (isMistake) {
        "The rule “$rule” is wrong. $message"
    } else {
        val end = if (message.last() in ".?!") "" else "."
        "The rule “$rule” was skipped for $logs log${if (logs == 1) "" else "s"}: $message$end"
    }
}

/**
 * Runs these rules over [view], which was read from a file called [file].
 *
 * @param beforeEach is called before each rule; what it throws stops the run and is passed on.
 */
public fun RuleSet.over(view: LogView, file: String, beforeEach: () -> Unit = {}): LogFindings {
    val findings = ArrayList<Finding>()
    val skipped = ArrayList<SkippedRule>()
    beforeEach()
    for (asked in RuleProgram(this, LogShape.of(view)).run(view, file)) {
        findings += asked.findings
        asked.refusal?.let { skipped += it.of(asked.rule, logs = 1) }
        beforeEach()
    }
    return LogFindings(findings, skipped)
}
