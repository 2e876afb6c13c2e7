package badlog.report

import badlog.recording.Severity

/** All findings match by match with time, severity and text, at most 100 characters wide, and below it what was not looked at. */
public fun reportText(result: ReportResult): String {
    val lines = ArrayList<String>()
    for (log in result.logs.filter { it.findings.isNotEmpty() }) {
        val table = TextTable(emptyList(), TextTable.WIDTH - INDENT.length)
        for (finding in log.findings) {
            val time = timeText(finding.time, finding.timeUnit)
            table.add(listOf(time.padStart(TIME_WIDTH), finding.severity.name.lowercase().padEnd(SEVERITY_WIDTH), finding.text))
        }
        lines += if (log.title == null) log.file.name else "${log.title} (${log.file.name})"
        lines += table.toString().prependIndent(INDENT)
        lines += ""
    }
    lines += summary(result)
    lines += notesOf(result)
    for (log in result.logs) log.unreadable?.let { lines += "${log.file.name}: $it" }
    return lines.joinToString("\n")
}

/** What was not looked for, and why: rules, virtual topics and hooks, each as a sentence or more. */
internal fun notesOf(result: ReportResult): List<String> {
    val readable = result.logs.filter { it.unreadable == null }
    return result.skipped.map { it.toString() } +
        undefinedTexts(readable.map { it.undefined }) +
        readable.flatMap { log -> log.hookFailures.map { "${log.file.name}, hook “${it.hook}”: ${it.message}" } }
}

/** Such as `2 errors, 1 warning and 0 notes in 3 of 12 logs.` */
internal fun summary(result: ReportResult): String {
    val counts = Severity.entries.sortedBy { ORDER.indexOf(it) }.map { count(result.count(it), it.name.lowercase()) }
    val found = result.logs.count { it.findings.isNotEmpty() }
    return "${counts.dropLast(1).joinToString()} and ${counts.last()} in $found of ${count(result.logs.size, "log")}."
}

private const val INDENT = "  "
private const val TIME_WIDTH = 10
private const val SEVERITY_WIDTH = 7

/** The worst first. */
internal val ORDER = listOf(Severity.ERROR, Severity.WARNING, Severity.NOTE)
