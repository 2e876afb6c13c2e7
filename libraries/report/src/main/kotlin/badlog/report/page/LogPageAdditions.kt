package badlog.report.page

import badlog.html.HookPart
import badlog.html.PageAdditions
import badlog.html.PageFigure
import badlog.html.PageFinding
import badlog.html.PageSeries
import badlog.report.hook.HookOutcome
import badlog.rules.Finding

/** What the page of a log shows besides the log: [virtualTopics], the [findings] of rules, and what [hooks] came to. */
public fun pageAdditions(virtualTopics: List<String>, findings: List<Finding>, hooks: List<HookOutcome> = emptyList()): PageAdditions =
    PageAdditions(virtualTopics, findings.filter { !it.isOfHook }.map(::pageFinding), hooks.map(::hookPart))

private fun pageFinding(finding: Finding): PageFinding {
    val first = finding.spans.firstOrNull()
    val until = if (first != null && first.width > 0) first.to else Double.NaN
    return PageFinding(finding.rule, finding.severity, finding.text, finding.time, until, finding.spans.drop(1))
}

private fun hookPart(outcome: HookOutcome): HookPart {
    val result = outcome.result ?: return HookPart(outcome.hook, error = outcome.failure?.message)
    return HookPart(
        outcome.hook,
        values = result.values,
        findings = result.findings.map { PageFinding(outcome.hook, it.severity, it.text, it.time, it.until) },
        series = result.series.map { PageSeries(it.name, it.unit, it.data) },
        figures = result.figures.map { PageFigure(it.title, it.mediaType, it.bytes) },
    )
}
