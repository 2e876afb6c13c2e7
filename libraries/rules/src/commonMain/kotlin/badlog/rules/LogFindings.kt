package badlog.rules

import badlog.core.analysis.LogView
import badlog.expression.signals.Vocabulary
import badlog.expression.vocabularyWith
import badlog.signals.LogShape
import badlog.signals.namesWith

/**
 * The result of rules for one log.
 *
 * @property findings the findings, in the order of the rules.
 * @property skipped the rules that were skipped, in order.
 * @property ran the number of rules that ran.
 */
class LogFindings(val findings: List<Finding>, val skipped: List<SkippedRule>, val ran: Int = 0) {
    /** Returns these findings, with the result [asked] added. */
    operator fun plus(asked: RuleResult): LogFindings = LogFindings(
        findings + asked.findings,
        skipped + listOfNotNull(asked.refusal?.of(asked.rule, logs = 1)),
        if (asked.refusal == null) ran + 1 else ran,
    )
}

/**
 * A rule that was skipped, usually because a log lacks its topics.
 *
 * @property rule its name.
 * @property logs the number of logs for which it was skipped.
 * @property message why it was skipped for the first of them.
 * @property isMistake whether the rule itself is wrong; [message] then points at the mistake in the file of rules.
 * @property isBuiltIn whether it is a built-in rule; few logs have the topics for all built-in rules.
 * @property lacking the signal that is missing in the first of those logs; null if there is another reason.
 * @property simulated why the first of those logs is considered simulated, if that is the reason; otherwise null.
 */
class SkippedRule(
    val rule: String,
    val logs: Int,
    val message: String,
    val isMistake: Boolean,
    val isBuiltIn: Boolean = false,
    val lacking: String? = null,
    val simulated: String? = null,
) {
    /** Returns the reason as a sentence, or as several if the rule is wrong. */
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
 * @param isEverywhere whether findings have all their spans, with a text for each, for going through them one by one.
 * @param beforeEach called before each rule; an exception from it stops the run and is passed on.
 */
fun RuleSet.over(view: LogView, file: String, isEverywhere: Boolean = false, beforeEach: () -> Unit = {}): LogFindings {
    var found = LogFindings(emptyList(), emptyList())
    beforeEach()
    for (asked in RuleProgram(this, LogShape.of(view)).run(view, file, isEverywhere)) {
        found += asked
        beforeEach()
    }
    return found
}

/**
 * Returns the rules that would be skipped for [view] with the virtual topics of [definitions]. [view] was read from a file called [file],
 * and needs no samples.
 */
fun RuleSet.skippedFor(view: LogView, file: String, definitions: List<String> = emptyList()): List<SkippedRule> {
    val defined = vocabularyWith(view.namesWith(signals), definitions).let { all ->
        Vocabulary(all.signals.filter { it.name !in all.meanings }, all.hasTime)
    }
    return RuleProgram(this, LogShape.of(view).copy(vocabulary = defined)).refusals(view.recording, file).map { (rule, refusal) ->
        refusal.of(rule, logs = 1)
    }
}
