package badlog.report.page

import badlog.core.recording.Severity
import badlog.report.LogReport
import badlog.rules.Finding
import badlog.rules.comparison.threeDigitText
import badlog.rules.number.LogNumbers
import badlog.rules.number.Measure

/**
 * Returns all readable logs in a table, the worst first. Each has its number of findings, its first finding, and the state of its battery.
 * The page's script can move the rows below the titles of [groups].
 */
internal fun overview(logs: List<IndexedLog>, groups: List<MatchGroup>): String {
    val ordered = groups.flatMapIndexed { index, group -> group.logs.map { it to index } }
    val places = ordered.mapIndexed { place, (log, group) -> log to "data-group=\"$group\" data-place=\"$place\"" }.toMap()
    val out = StringBuilder("<table class=\"overview\">\n<thead><tr><th scope=\"col\">Match</th>")
    for (title in listOf("Errors", "Warnings", "Notes")) out.append("<th scope=\"col\" class=\"count\">$title</th>")
    out.append("<th scope=\"col\" class=\"first\">Main finding</th>")
    for ((title, unit) in NUMBERS) out.append("<th scope=\"col\" class=\"count figure\">$title<br><small>$unit</small></th>")
    out.append("</tr></thead>\n<tbody>\n")
    for (log in logs.sortedWith(WORST_FIRST)) out.append(row(log, places.getValue(log)))
    out.append("</tbody>\n")
    for (group in groups) {
        val title = "<th scope=\"rowgroup\" colspan=\"$COLUMNS\">${escaped(group.title)}</th>"
        out.append("<tbody class=\"group\" hidden=\"\"><tr>$title</tr></tbody>\n")
    }
    return out.append("</table>\n").toString()
}

private val WORST_FIRST = compareBy<IndexedLog>(
    { log -> -(log.report.incidents.maxOfOrNull { it.severity.ordinal } ?: -1) },
    { log -> -log.report.count(Severity.ERROR) },
    { log -> -log.report.count(Severity.WARNING) },
    { log -> -log.report.count(Severity.NOTE) },
    { log -> log.number },
)

private fun row(log: IndexedLog, place: String): String {
    val out = StringBuilder("<tr ${log.data} $place>")
    val hasPart = log.report.findings.isNotEmpty()
    val name = if (hasPart) "<a href=\"#${log.id}\">${escaped(log.shortName)}</a>" else linked(log.shortName, log.page)
    out.append("<th scope=\"row\">$name${log.blueAlliance}</th>")
    for (severity in listOf(Severity.ERROR, Severity.WARNING, Severity.NOTE)) {
        val count = log.report.count(severity)
        val cell = if (count == 0) "–" else "<span class=\"of-${severity.cssClass}\">$count</span>"
        out.append("<td class=\"count\">$cell</td>")
    }
    val (first, finding) = firstOf(log.report)
    out.append("<td class=\"first\">${linked(first, log.page.takeIf { hasPart }, finding)}</td>")
    for ((_, _, number) in NUMBERS) {
        val value = number(log.report.numbers)
        out.append("<td class=\"count figure\">${if (value.isNaN()) "–" else escaped(threeDigitText(value, ""))}</td>")
    }
    return out.append("</tr>\n").toString()
}

/** Returns the first incident or finding of [report], and the finding that shows it. */
private fun firstOf(report: LogReport): Pair<String, Finding?> = report.incidents.firstOrNull()?.let { it.name to it.first }
    ?: report.findings.firstOrNull()?.let { it.text to it } ?: ("Nothing found" to null)

private fun LogReport.count(severity: Severity) = findings.count { it.severity == severity }

private const val COLUMNS = 7
private val NUMBERS = listOf<Triple<String, String, (LogNumbers) -> Double>>(
    Triple("Battery low", "V") { it.of("battery", Measure.LOWEST) },
    Triple("Resistance", "mΩ") { it.resistance },
)
