package badlog.report.page

import badlog.file.LogFile
import badlog.html.BADLOG_VERSION
import badlog.plot.color.Shade
import badlog.plot.color.cssColor
import badlog.recording.Severity
import badlog.report.LogReport
import badlog.report.ORDER
import badlog.report.ReportResult
import badlog.report.notesOf
import badlog.report.shortNames
import badlog.report.summary
import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.rules.timeText
import badlog.terminal.printable
import java.net.URLEncoder
import java.security.MessageDigest
import java.util.Base64

/**
 * One page that shows all findings and needs nothing else: no network, no script. It follows the system's light or dark colors.
 *
 * Each finding links to the page of its log at the finding's time, by the fragment `#t=` and the time in the unit of the log's x axis:
 * `Q42.html#t=93.7`.
 *
 * @param title what stands above everything.
 * @param pageOf where the page of a log is, as a path with `/` relative to this page, or null without one.
 */
public fun reportPage(result: ReportResult, title: String = "Report", pageOf: (LogReport) -> String? = { null }): String {
    val style = ":root { color-scheme: light dark; ${colors(isDark = false)} }\n" +
        "@media (prefers-color-scheme: dark) { :root { ${colors(isDark = true)} } }\n" + STYLE.trimIndent()
    val out = StringBuilder()
    out.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n")
    out.append("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'sha256-${hash(style)}'; ")
    out.append("base-uri 'none'; form-action 'none'\">\n")
    out.append("$GENERATOR${escaped(BADLOG_VERSION)}\">\n")
    out.append("<meta name=\"viewport\" content=\"width=device-width\">\n<meta name=\"color-scheme\" content=\"light dark\">\n")
    out.append("<title>${escaped(title)}</title>\n<style>$style</style>\n</head>\n<body>\n")
    out.append("<h1>${escaped(title)}</h1>\n<p>${escaped(summary(result))}</p>\n")
    val names = shortNames(result.logs.map { it.file })
    val withFindings = result.logs.filter { it.findings.isNotEmpty() }
    if (withFindings.isNotEmpty()) appendTable(out, withFindings, names, pageOf)
    appendList(out, "Skipped", notesOf(result))
    appendList(out, "Unreadable", result.logs.mapNotNull { log -> log.unreadable?.let { "${names[log.file]}: $it" } })
    val clean = result.logs.filter { it.findings.isEmpty() && it.unreadable == null }
    appendLogs(out, clean, names, pageOf)
    out.append("</body>\n</html>\n")
    return out.toString()
}

private fun appendTable(out: StringBuilder, logs: List<LogReport>, names: Map<LogFile, String>, pageOf: (LogReport) -> String?) {
    out.append("<table>\n<thead><tr><th>Match</th><th>Time</th><th>Severity</th><th>Rule</th><th>Finding</th></tr></thead>\n")
    for (log in logs) {
        val page = pageOf(log)
        val name = names.getValue(log.file)
        out.append("<tbody>\n")
        val incidents = log.incidents.map { it.severity to incidentCells(it, page) }
        val findings = log.findings.sortedBy { ORDER.indexOf(it.severity) }.map { it.severity to findingCells(it, page) }
        (incidents + findings).forEachIndexed { index, (severity, cells) ->
            out.append("<tr class=\"${severity.name.lowercase()}\">")
            if (index == 0) {
                out.append("<th scope=\"rowgroup\" rowspan=\"${incidents.size + findings.size}\">${linked(log.title ?: name, page, "")}")
                if (log.title != null) out.append("<br><small>${escaped(name)}</small>")
                out.append("</th>")
            }
            out.append(cells).append("</tr>\n")
        }
        out.append("</tbody>\n")
    }
    out.append("</table>\n")
}

private fun findingCells(finding: Finding, page: String?): String =
    cellsBefore(finding.time, finding.timeUnit, finding.severity, finding.rule, page) + "<td>${escaped(finding.text)}</td>"

/** What came first and what followed, each a link to its evidence. */
private fun incidentCells(incident: Incident, page: String?): String {
    val told = incident.sentences.joinToString(" ") { linked(it.text, page, fragmentOf(it.finding)) }
    val next = if (incident.next.isEmpty()) "" else "<br><small>Next: ${escaped(incident.next)}</small>"
    return cellsBefore(incident.time, incident.timeUnit, incident.severity, "Incident", page) + "<td>$told$next</td>"
}

private fun cellsBefore(time: Double, unit: String, severity: Severity, rule: String, page: String?): String =
    "<td class=\"time\">${linked(timeText(time, unit), page, fragmentOf(time))}</td>" +
        "<td><b>${severity.name.lowercase()}</b></td><td>${escaped(rule)}</td>"

private fun appendList(out: StringBuilder, title: String, items: List<String>) {
    if (items.isEmpty()) return
    out.append("<h2>$title</h2>\n<ul>\n")
    for (item in items) out.append("<li>${escaped(item)}</li>\n")
    out.append("</ul>\n")
}

private fun appendLogs(out: StringBuilder, logs: List<LogReport>, names: Map<LogFile, String>, pageOf: (LogReport) -> String?) {
    if (logs.isEmpty()) return
    out.append("<details>\n<summary>Nothing found in ${logs.size}</summary>\n<ul>\n")
    for (log in logs) out.append("<li>${linked(log.title ?: names.getValue(log.file), pageOf(log), "")}</li>\n")
    out.append("</ul>\n</details>\n")
}

/** `#t=` and the time, or nothing for a finding without one. */
private fun fragmentOf(finding: Finding): String = fragmentOf(finding.time)

private fun fragmentOf(time: Double): String = if (time.isFinite()) "#t=" + time.toBigDecimal().stripTrailingZeros().toPlainString() else ""

private fun linked(text: String, page: String?, fragment: String): String =
    if (page == null || text.isEmpty()) escaped(text) else "<a href=\"${escaped("./" + urlOf(page))}$fragment\">${escaped(text)}</a>"

/** [path] with everything but plain characters encoded, so that no name becomes a scheme, a query or a fragment. */
private fun urlOf(path: String): String = path.split('/').joinToString("/") { URLEncoder.encode(it, Charsets.UTF_8).replace("+", "%20") }

private fun escaped(text: String): String = buildString(text.length) {
    for (char in text.split('\n').joinToString("\n", transform = ::printable)) {
        when (char) {
            '&' -> append("&amp;")
            '<' -> append("&lt;")
            '>' -> append("&gt;")
            '"' -> append("&quot;")
            '\'' -> append("&#39;")
            else -> append(char)
        }
    }
}

/** How the pages of badlog say what made them; its version follows. */
internal const val GENERATOR = "<meta name=\"generator\" content=\"badlog "

private fun hash(text: String): String =
    Base64.getEncoder().encodeToString(MessageDigest.getInstance("SHA-256").digest(text.encodeToByteArray()))

private fun colors(isDark: Boolean) = USED_SHADES.joinToString(" ") { "--${it.name.lowercase()}: ${cssColor(it.of(isDark))};" }

private val USED_SHADES =
    listOf(Shade.TEXT, Shade.PAGE, Shade.SURFACE, Shade.BORDER, Shade.MUTED, Shade.ACCENT, Shade.ERROR, Shade.WARNING)

private const val STYLE = """
    body { margin: 2rem auto; padding: 0 1rem; max-width: 75rem; background: var(--page); color: var(--text);
      font: 15px/1.45 system-ui, sans-serif; }
    h1 { font-size: 1.5rem; } h2 { font-size: 1.1rem; }
    table { width: 100%; border-collapse: collapse; background: var(--surface); border: 1px solid var(--border); }
    th, td { padding: .4rem .6rem; text-align: left; vertical-align: top; border-top: 1px solid var(--border); overflow-wrap: anywhere; }
    thead th { color: var(--muted); font-weight: 600; } tbody { border-top: 2px solid var(--border); }
    .time { white-space: nowrap; font-variant-numeric: tabular-nums; } small { color: var(--muted); font-weight: 400; }
    .error b { color: var(--error); } .warning b { color: var(--warning); } .note b { color: var(--muted); }
    a { color: var(--accent); } li { white-space: pre-wrap; }
"""
