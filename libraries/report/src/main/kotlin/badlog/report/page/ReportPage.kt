package badlog.report.page

import badlog.exporter.BADLOG_VERSION
import badlog.report.LogReport
import badlog.report.ReportResult
import badlog.report.notesOf
import badlog.report.shortNames
import badlog.report.summary
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.cssColor

/**
 * Returns a page that shows all incidents and findings and needs nothing else. It has no library, and a script only for filtering and
 * searching. It follows the system's light or dark colors.
 *
 * Each finding links to its place on the page of its log, by a fragment with its time in the unit of the log's x axis, its rule and its
 * topic: `Q42.html#t=93.7&finding=Brownout;Voltage`.
 *
 * @param title the heading of the page.
 * @param charts the charts of all logs, with files beside the page.
 * @param pageOf returns the place of a log's page, as a path with `/` relative to this page; null if there is none.
 */
fun reportPage(
    result: ReportResult,
    title: String = "Report",
    charts: PageCharts = PageCharts.NONE,
    pageOf: (LogReport) -> String? = { null },
): String {
    val names = shortNames(result.logs.map { it.file })
    val readable = result.logs.filter { it.unreadable == null }
    val event = eventOf(readable.mapNotNull { it.title })
    val logs = readable.mapIndexed { number, log -> IndexedLog(number, log, names.getValue(log.file), pageOf(log), event) }
    val heading = if (event.isEmpty()) title else "$title: $event"
    val out = StringBuilder(head(heading, charts.all.isNotEmpty()))
    out.append("<a class=\"skip\" href=\"#matches\">Skip to the matches</a>\n<main>\n")
    out.append("<h1>${escaped(heading)}</h1>\n<p class=\"summary\">${escaped(summary(result))}</p>\n")
    val groups = groupsOf(logs)
    if (logs.isNotEmpty()) out.append(filterForm(logs, groups)).append("<h2 id=\"matches\">Matches</h2>\n").append(overview(logs, groups))
    appendSection(out, "Batteries", batteriesPart(result.batteries))
    appendSection(out, "Trends", trends(logs))
    appendSection(out, "Charts", chartsPart(charts))
    appendSection(out, "Incidents and findings", logs.filter { it.report.findings.isNotEmpty() }.joinToString("", transform = ::matchPart))
    appendList(out, "Skipped", notesOf(result) + result.batteries.problems)
    appendList(out, "Unreadable", result.logs.mapNotNull { log -> log.unreadable?.let { "${names[log.file]}: $it" } })
    return out.append("</main>\n<script>$SCRIPT</script>\n</body>\n</html>\n").toString()
}

/** Returns the event: the first words that all of [titles] share, without their last two, the match. Empty if there is none. */
private fun eventOf(titles: List<String>): String {
    if (titles.size < 2) return ""
    val words = titles.map { it.split(' ') }
    val most = words.minOf { it.size } - 2
    return (0 until most).takeWhile { place -> words.all { it[place] == words[0][place] } }.joinToString(" ") { words[0][it] }
}

private fun head(title: String, hasPictures: Boolean): String {
    val style = ":root { color-scheme: light dark; ${colors(isDark = false)} }\n" +
        "@media screen and (prefers-color-scheme: dark) { :root { ${colors(isDark = true)} } }\n" + STYLE
    // Pictures are files beside the page.
    val pictures = if (hasPictures) " img-src 'self';" else ""
    val policy = "default-src 'none';$pictures style-src '${hashOf(
        style,
    )}'; script-src '${hashOf(SCRIPT)}'; base-uri 'none'; form-action 'none'"
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n" +
        "<meta http-equiv=\"Content-Security-Policy\" content=\"$policy\">\n$GENERATOR${escaped(BADLOG_VERSION)}\">\n" +
        "<meta name=\"viewport\" content=\"width=device-width\">\n<meta name=\"color-scheme\" content=\"light dark\">\n" +
        "<title>${escaped(title)}</title>\n<style>$style</style>\n</head>\n<body>\n"
}

private fun appendSection(out: StringBuilder, title: String, content: String) {
    if (content.isNotEmpty()) out.append("<h2>$title</h2>\n").append(content)
}

private fun appendList(out: StringBuilder, title: String, items: List<String>) {
    if (items.isEmpty()) return
    appendSection(out, title, items.joinToString("", "<ul class=\"notes\">\n", "</ul>\n") { "<li>${escaped(it)}</li>\n" })
}

/** The generator mark of badlog's pages; the version follows it. */
internal const val GENERATOR = "<meta name=\"generator\" content=\"badlog "

private fun colors(isDark: Boolean) = Shade.entries.joinToString(" ") { "--${it.name.lowercase()}: ${cssColor(it.of(isDark))};" }

private val STYLE by lazy { resource("index.css") }

private val SCRIPT by lazy { resource("filter.js") }

private fun resource(name: String): String =
    checkNotNull(IndexedLog::class.java.getResourceAsStream(name)).use { it.readBytes().decodeToString() }
