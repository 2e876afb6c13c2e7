package badlog.report

import badlog.terminal.printable

/**
 * All findings as CSV (RFC 4180): one line for each, with the file, the match, the rule, its severity, the topic, the text, the time to
 * look at first, the end of the first span, how many spans there are, and the unit of the times. A log that cannot be read has a
 * line too, with the rule `unreadable`; what is not a log has none.
 */
public fun reportCsv(result: ReportResult): String {
    val out = StringBuilder()
    fun line(vararg cells: String) {
        cells.joinTo(out, ",", transform = ::cell)
        out.append("\r\n")
    }
    line("file", "match", "rule", "severity", "topic", "text", "time", "until", "spans", "time unit")
    for (log in result.logs) {
        val file = log.file.path.toString()
        val title = log.title.orEmpty()
        log.unreadable?.takeUnless { log.isNoLog }?.let { line(file, title, "unreadable", "error", "", it, "", "", "", "") }
        for (finding in log.findings) {
            line(
                file, title, finding.rule, finding.severity.name.lowercase(), finding.topic.orEmpty(), finding.text,
                plain(finding.time), plain(finding.spans.firstOrNull()?.to ?: Double.NaN), finding.spanCount.toString(),
                finding.timeUnit,
            )
        }
    }
    return out.toString()
}

/** [number] with all its digits; empty where it is not finite. */
internal fun plain(number: Double) = if (number.isFinite()) number.toBigDecimal().stripTrailingZeros().toPlainString() else ""

/** [text] as a cell of CSV that no spreadsheet takes for a formula. */
internal fun cell(text: String): String {
    // A spreadsheet would calculate what begins so; names and texts come from files.
    val shown = text.lines().joinToString("\n", transform = ::printable)
    val safe = if (shown.isNotEmpty() && shown[0] in "=+-@" && shown.toDoubleOrNull() == null) "'$shown" else shown
    val needsQuotes = safe.any { it in "\",\r\n" } || safe != safe.trim()
    return if (needsQuotes) "\"${safe.replace("\"", "\"\"")}\"" else safe
}
