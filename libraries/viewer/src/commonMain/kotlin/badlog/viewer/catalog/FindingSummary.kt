package badlog.viewer.catalog

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.incident.MainFinding
import badlog.rules.incident.incidentsIn
import badlog.rules.incident.mainFinding
import badlog.rules.incident.nextOf
import badlog.viewer.text.minutesText
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit
import kotlin.math.floor

/**
 * The findings of the rules in a log of the folder.
 *
 * @property key identifies the rules that were run; if the rules have another key, they are run again.
 * @property rules the rules that found something, each once, the worst first; null if they could not be run.
 * @property verdict the summary to show first; null if nothing is worse than a note.
 */
data class FindingSummary(val key: Int, val rules: List<FoundRule>?, val verdict: Verdict? = null) {
    /** The worst severity; null if nothing was found. */
    val worst: Severity? get() = rules?.maxOfOrNull { it.severity }

    /** Returns the number of rules that found something of [severity]. */
    fun count(severity: Severity): Int = rules.orEmpty().count { it.severity == severity }
}

/** A rule that found something. */
data class FoundRule(val name: String, val severity: Severity)

/**
 * The rules' summary of a log, for a reader who has only a moment.
 *
 * @property severity the severity of its main finding.
 * @property headline the event and its time, without a full stop: `Browned out at 1:33`.
 * @property sentences the causes and consequences, in order; at least one sentence.
 * @property next the next thing to look at, as a sentence; empty if unknown.
 * @property errors the number of findings that are errors.
 * @property warnings the number of findings that are warnings.
 */
data class Verdict(
    val severity: Severity,
    val headline: String,
    val sentences: List<String>,
    val next: String = "",
    val errors: Int = 0,
    val warnings: Int = 0,
)

/** Returns the summary of [findings] for lists of logs. These rules found them; [key] identifies the rules. */
fun RuleSet.foundIn(findings: List<Finding>, key: Int): FindingSummary {
    val first = mainFinding(findings, incidentsIn(findings)) ?: return FindingSummary(key, emptyList())
    val listed = (listOf(first.finding) + findings).map { FoundRule(it.rule, it.severity) }
    return FindingSummary(key, listed.sortedByDescending { it.severity }.distinctBy { it.name }, verdictOf(first, findings))
}

private fun verdictOf(first: MainFinding, findings: List<Finding>): Verdict? {
    val finding = first.finding
    if (findings.all { it.severity == Severity.NOTE }) return null
    return Verdict(
        finding.severity,
        if (finding.time.isNaN()) finding.rule else "${finding.rule} at ${timeText(finding)}",
        first.incident?.sentences?.map { it.text } ?: listOf(finding.text),
        first.incident.nextOf(finding),
        findings.count { it.severity == Severity.ERROR },
        findings.count { it.severity == Severity.WARNING },
    )
}

// Rounds down, as a clock does: it shows 1:33 until 1:34.
private fun timeText(finding: Finding) = secondsOf(finding.time, finding.timeUnit)?.let { minutesText(floor(it), decimals = 0) }
    ?: withUnit(numberText(finding.time), finding.timeUnit)
