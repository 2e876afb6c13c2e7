package badlog.report

import badlog.core.recording.Severity
import badlog.files.LogFile
import badlog.files.terminal.TextTable
import badlog.files.terminal.TextTable.Column
import badlog.files.terminal.printable
import badlog.rules.NotLookedAt
import badlog.rules.SkippedRule
import badlog.rules.comparison.resistanceText
import badlog.rules.incident.Incident
import badlog.rules.lackingIn
import badlog.rules.listed
import badlog.rules.timeText

/**
 * Returns all incidents and findings, match by match, at most [width] columns wide. Each has time, severity and text. Skipped rules and
 * hooks are below them. Logs that cannot be read are only counted; files that are not logs are not mentioned.
 */
fun reportText(result: ReportResult, width: Int = TEXT_WIDTH): String {
    val table = TextTable(COLUMNS, if (width == Int.MAX_VALUE) width else width - INDENT.length)
    val names = shortNames(result.logs.map { it.file })
    val lines = ArrayList<String>()
    for (log in result.logs.filter { it.findings.isNotEmpty() }) {
        val name = names.getValue(log.file)
        val resistance = resistanceText(log.numbers).let { if (it.isEmpty()) "" else ", battery $it" }
        lines += TextTable.shortened(printable(if (log.title == null) name else "${log.title} ($name)") + resistance, width)
        val incidents = log.incidents.flatMap(::rowsOf)
        val rows =
            incidents +
                log.findings.map { listOf(timeText(it.time, it.timeUnit), it.severity.name.lowercase().padEnd(SEVERITY_WIDTH), it.text) }
        // The times of all logs are aligned.
        lines += table.lines(rows.map { row -> listOf(row[0].padStart(TIME_WIDTH)) + row.drop(1) }).flatten().map { INDENT + it }
        lines += ""
    }
    lines += summary(result)
    lines += notesOf(result)
    return lines.joinToString("\n")
}

/** Returns what came first, what followed, and what to look at next. */
private fun rowsOf(incident: Incident): List<List<String>> {
    val sentences = incident.sentences.mapIndexed { index, sentence ->
        val label = when {
            index == 0 -> incident.severity.name.lowercase()
            sentence.finding === incident.difference -> "differs"
            else -> "then"
        }
        listOf(timeText(sentence.finding.time, incident.timeUnit), label.padEnd(SEVERITY_WIDTH), sentence.text)
    }
    return if (incident.next.isEmpty()) sentences else sentences + listOf(listOf("", "next".padEnd(SEVERITY_WIDTH), incident.next))
}

/** Returns the skipped rules, virtual topics and hooks with the reasons, each as one or more sentences. */
fun notesOf(result: ReportResult): List<String> {
    val readable = result.logs.filter { it.unreadable == null }
    val (builtIn, others) = result.skipped.partition { it.isBuiltIn && !it.isMistake }
    val alone = readable.singleOrNull()?.takeIf { builtIn.isNotEmpty() }
    val unseen =
        alone?.let { (if (it.findings.isEmpty()) "Nothing found. " else "") + notLookedAtText(it.notLookedAt) } ?: builtInText(builtIn)
    val toLog = howToLogText(if (alone != null) alone.notLookedAt.lacking else lackingIn(builtIn))
    val simulated = if (readable.size > 1) simulatedText(readable.filter { it.notLookedAt.simulated != null }) else null
    return listOfNotNull(unseen, toLog, simulated) + others.map { it.toString() } + undefinedTexts(readable.map { it.undefined }) +
        hookTexts(readable.flatMap { log -> log.hookFailures.map { it to log.file } })
}

/** Says which of many logs are [simulated]; null for none. */
private fun simulatedText(simulated: List<LogReport>): String? {
    if (simulated.isEmpty()) return null
    val names = simulated.take(MAX_SIMULATED).joinToString { "“${it.file.name}”" }
    val others = simulated.size - MAX_SIMULATED
    val all = if (others > 0) "$names and $others more" else names
    return "${count(
        simulated.size,
        "log",
    )} of a simulation: $all. Rules about power, wear and sensors did not run over ${if (simulated.size == 1) "it" else "them"}."
}

private const val MAX_SIMULATED = 5

private fun notLookedAtText(notLookedAt: NotLookedAt): String =
    notLookedAt.text + if (notLookedAt.lacking.isEmpty()) "" else " If one of its topics is that signal, say so with badlog assign."

/** No log has all topics of the built-in rules. */
private fun builtInText(skipped: List<SkippedRule>): String? {
    if (skipped.isEmpty()) return null
    val lacking = lackingIn(skipped)
    val needed = if (lacking.isEmpty()) "" else "\nMost of them need ${listed(lacking, most = 3)}."
    return "${count(skipped.size, "built-in rule")} did not run over some of these logs; see badlog info --signals.$needed"
}

/** Returns a text for each hook in [failures], with its first error: a hook that fails for one log usually fails for all. */
internal fun hookTexts(failures: List<Pair<HookFailure, LogFile>>): List<String> =
    failures.groupBy { (failure, _) -> failure.hook }.map { (hook, alike) ->
        val (failure, file) = alike[0]
        val place = if (alike.size == 1) file.name else count(alike.size, "log")
        val first = if (alike.distinctBy { it.first.message }.size == 1) "" else ", in the first, ${file.name}"
        "$place, hook “$hook”$first: ${failure.message}"
    }

/** Returns a summary, such as `2 errors, 1 warning and 0 notes in 3 of 12 logs.` */
internal fun summary(result: ReportResult): String {
    val counts = ORDER.map { count(result.count(it), it.name.lowercase()) }
    val found = result.logs.count { it.findings.isNotEmpty() }
    return "${counts.dropLast(1).joinToString()} and ${counts.last()} in $found of ${count(result.logs.count { !it.isNoLog }, "log")}."
}

/** All severities, the worst first. */
internal val ORDER = listOf(Severity.ERROR, Severity.WARNING, Severity.NOTE)

private const val INDENT = "  "
private const val TIME_WIDTH = 10
private const val SEVERITY_WIDTH = 7
private val COLUMNS = listOf(Column("", isWhole = true), Column("", isWhole = true), Column(""))
