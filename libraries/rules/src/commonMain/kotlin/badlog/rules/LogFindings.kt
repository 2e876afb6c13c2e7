package badlog.rules

import badlog.analysis.LogView
import badlog.expression.signals.Vocabulary
import badlog.expression.vocabularyWith

/**
 * What rules say of one log.
 *
 * @property findings in the order of the rules.
 * @property skipped the rules that were skipped, in their order.
 */
public class LogFindings(public val findings: List<Finding>, public val skipped: List<SkippedRule>) {
    /** These and what [asked] came to. */
    public operator fun plus(asked: AskedRule): LogFindings =
        LogFindings(findings + asked.findings, skipped + listOfNotNull(asked.refusal?.of(asked.rule, logs = 1)))
}

/**
 * A rule that was skipped, mostly because a log lacks its topics.
 *
 * @property rule its name.
 * @property logs for how many logs.
 * @property message why, in the first of them.
 * @property isMistake whether the rule itself is wrong; [message] then points at the mistake in the file of rules.
 * @property isBuiltIn whether it is one of badlog's own, which few logs have all topics for.
 */
public class SkippedRule(
    public val rule: String,
    public val logs: Int,
    public val message: String,
    public val isMistake: Boolean,
    public val isBuiltIn: Boolean = false,
) {
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
 * @param isEverywhere whether findings have all their spans, with a text for each, as for somebody who looks at them one by one.
 * @param beforeEach is called before each rule; what it throws stops the run and is passed on.
 */
public fun RuleSet.over(view: LogView, file: String, isEverywhere: Boolean = false, beforeEach: () -> Unit = {}): LogFindings {
    var found = LogFindings(emptyList(), emptyList())
    beforeEach()
    for (asked in RuleProgram(this, LogShape.of(view)).run(view, file, isEverywhere)) {
        found += asked
        beforeEach()
    }
    return found
}

/** The rules that would be skipped for [view], which needs no samples for it, with the topics that [definitions] make there. */
public fun RuleSet.skippedFor(view: LogView, definitions: List<String> = emptyList()): List<SkippedRule> {
    val defined = vocabularyWith(view.namesWith(signals), definitions).let { all ->
        Vocabulary(all.signals.filter { it.name !in all.meanings }, all.hasTime)
    }
    return RuleProgram(this, LogShape.of(view).copy(vocabulary = defined)).refusals(view.recording).map { (rule, refusal) ->
        refusal.of(rule, logs = 1)
    }
}
