package badlog.report.page

import badlog.core.recording.Severity
import badlog.report.LogReport
import badlog.report.ORDER
import badlog.rules.Finding
import badlog.rules.comparison.resistanceText
import badlog.rules.comparison.threeDigitText
import badlog.rules.incident.Incident
import badlog.rules.number.Measure
import badlog.rules.timeText

/** A log on the index page. */
internal class IndexedLog(val number: Int, val report: LogReport, val file: String, val page: String?, event: String) {
    val name: String get() = report.title ?: file

    /** Its name without the event's name, if all logs are of the same event. */
    val shortName: String = report.title?.removePrefix(event)?.trim() ?: file

    /** The id by which links find its part of the page. */
    val id: String get() = "log-$number"

    /** The link to its match on The Blue Alliance, as HTML that follows its name; empty if the match is unknown there. */
    val blueAlliance: String
        get() {
            val address = blueAllianceOf(report.match, yearOf(report)) ?: return ""
            val label = "TBA: ${escaped(name)} on The Blue Alliance"
            return " <a class=\"alliance\" href=\"$address\" rel=\"noreferrer\" aria-label=\"$label\">TBA</a>"
        }

    /** The attributes by which the page's filter finds the elements for this log. */
    val data: String get() = "data-log=\"$number\" data-type=\"${escaped(report.matchType.orEmpty())}\""
}

/** Returns the incidents of [log], then its findings, both with the worst first, and with links to their moments. */
internal fun matchPart(log: IndexedLog): String {
    val report = log.report
    val out = StringBuilder("<article id=\"${log.id}\" class=\"match card\" ${log.data} aria-labelledby=\"${log.id}-name\">\n")
    out.append("<header><h3 id=\"${log.id}-name\">${linked(log.name, log.page)}</h3>${log.blueAlliance}")
    if (report.title != null) out.append("<small>${escaped(log.file)}</small>")
    out.append("</header>\n")
    val facts = factsOf(report)
    if (facts.isNotEmpty()) out.append("<p class=\"facts\">${escaped(facts)}</p>\n")
    if (report.incidents.isNotEmpty()) {
        out.append("<ol class=\"incidents\" aria-label=\"Incidents\">\n")
        for (incident in report.incidents) out.append(incidentItem(incident, log.page))
        out.append("</ol>\n")
    }
    out.append("<ol class=\"findings\" aria-label=\"Findings\">\n")
    for (finding in report.findings.sortedBy { ORDER.indexOf(it.severity) }) out.append(findingItem(finding, log.page))
    return out.append("</ol>\n</article>\n").toString()
}

private fun factsOf(report: LogReport): String {
    val lowest = report.numbers.of("battery", Measure.LOWEST)
    val resistance = resistanceText(report.numbers)
    return listOfNotNull(
        lowest.takeUnless { it.isNaN() }?.let { "battery down to ${threeDigitText(it, "V")}" },
        resistance.takeIf { it.isNotEmpty() }?.let { "battery and wiring $it" },
    ).joinToString(" · ")
}

private fun findingItem(finding: Finding, page: String?): String {
    val content = "<span class=\"rule\">${escaped(finding.rule)}</span>${escaped(finding.text)}"
    return item(finding.severity, finding, page) + "<div class=\"text\">$content</div></li>\n"
}

/** Returns the sentences of [incident] in their order, each as a link to its evidence. */
private fun incidentItem(incident: Incident, page: String?): String {
    val content = incident.sentences.joinToString("") { "<p>${linked(it.text, page, it.finding)}</p>" }
    val next = if (incident.next.isEmpty()) "" else "<p class=\"next\">Next: ${escaped(incident.next)}</p>"
    return item(incident.severity, incident.first, page) + "<div class=\"text\">$content$next</div></li>\n"
}

private fun item(severity: Severity, finding: Finding, page: String?): String {
    val moment = if (finding.time.isFinite()) linked(timeText(finding.time, finding.timeUnit), page, finding) else "whole log"
    return "<li class=\"${severity.cssClass}\" data-level=\"${severity.ordinal}\"><span class=\"severity\">${severity.cssClass}</span>" +
        "<span class=\"time\">$moment</span>"
}
