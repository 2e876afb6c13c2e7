package badlog.report

import badlog.files.terminal.printable
import badlog.rules.Finding
import badlog.rules.incident.Incident

/**
 * Returns all incidents and findings as CSV (RFC 4180), one line for each. The columns are the file, the match, the rule, its severity, the
 * topic, the text, the time to look at first, the end of the first span, the number of spans, the unit of the times, the incident of a
 * finding, and the next step. An incident has the rule `incident`, and comes before the findings of its log. An unreadable log also has a
 * line, with the rule `unreadable`; a file that is not a log has none.
 */
fun reportCsv(result: ReportResult): String {
    val out = StringBuilder()
    fun line(cells: List<String>) {
        cells.joinTo(out, ",", transform = ::cell)
        out.append("\r\n")
    }
    line(listOf("file", "match", "rule", "severity", "topic", "text", "time", "until", "spans", "time unit", "incident", "next"))
    for (log in result.logs) {
        val head = listOf(log.file.path.toString(), log.title.orEmpty())
        log.unreadable?.takeUnless { log.isNoLog }?.let { line(head + listOf("unreadable", "error", "", it) + List(NOTHING) { "" }) }
        log.incidents.forEach { line(head + cellsOf(it)) }
        log.findings.forEach { line(head + cellsOf(it, log)) }
    }
    return out.toString()
}

private fun cellsOf(incident: Incident) = listOf(
    "incident", incident.severity.name.lowercase(), "", incident.sentences.joinToString(" ") { it.text }, plain(incident.time), "", "",
    incident.timeUnit, incident.name, incident.next,
)

private fun cellsOf(finding: Finding, log: LogReport) = listOf(
    finding.rule, finding.severity.name.lowercase(), finding.topic.orEmpty(), finding.text, plain(finding.time),
    plain(finding.spans.firstOrNull()?.to ?: Double.NaN), finding.spanCount.toString(), finding.timeUnit,
    log.incidents.find { finding in it.causes || finding in it.effects }?.name.orEmpty(), finding.next,
)

/** The number of empty cells for an unreadable log. */
private const val NOTHING = 6

/** Returns [number] with all its digits; empty if it is not finite. */
internal fun plain(number: Double) = if (number.isFinite()) number.toBigDecimal().stripTrailingZeros().toPlainString() else ""

/** Returns [text] as a cell of CSV that no spreadsheet takes for a formula. */
internal fun cell(text: String): String {
    // A spreadsheet would evaluate text that begins like this; names and texts come from files.
    val shown = text.lines().joinToString("\n", transform = ::printable)
    val safe = if (shown.isNotEmpty() && shown[0] in "=+-@" && shown.toDoubleOrNull() == null) "'$shown" else shown
    val needsQuotes = safe.any { it in "\",\r\n" } || safe != safe.trim()
    return if (needsQuotes) "\"${safe.replace("\"", "\"\"")}\"" else safe
}
