package badlog.page.view

import badlog.rules.Finding
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.text.countText
import badlog.viewer.text.word

/** Returns [findings] by their places on the x axis. */
internal fun timelineOf(findings: List<Finding>): FindingTimeline<Finding> = FindingTimeline(findings, { it.severity }, { it.places })

/** Returns the finding's text at its place nearest to [x]. */
internal fun Finding.textNear(x: Double): String = placeNear(x)?.let(::textAt) ?: text

/** Returns the first of [findings] with its severity and its text near [x], and the number of the others. */
internal fun findingText(findings: List<Finding>, x: Double): String {
    val first = findings.firstOrNull() ?: return ""
    return "${first.severity.word} · ${shortFindingText(findings, x)}"
}

/** Returns the same as [findingText], without the severity. */
internal fun shortFindingText(findings: List<Finding>, x: Double): String {
    val others = if (findings.size > 1) " (and ${countText(findings.size - 1)} more)" else ""
    return "${findings[0].rule}: ${findings[0].textNear(x)}$others"
}
