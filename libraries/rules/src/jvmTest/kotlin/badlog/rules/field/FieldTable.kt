package badlog.rules.field

import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import java.io.File

/**
 * Runs the built-in rules over a folder of real logs. Writes where each could run, where it fired, and which of its findings were judged. Arguments:
 * the folder, the file of judgements (empty for none), the file to write.
 */
internal fun main(arguments: Array<String>) {
    val logs = fieldLogsIn(File(arguments[0]))
    val judged = arguments[1].takeIf { it.isNotEmpty() }?.let { judgementsIn(File(it).readText()) }.orEmpty()
    val text = fieldTable(logs, judged)
    println(text)
    File(arguments[2]).apply { parentFile.mkdirs() }.writeText(text + openQuestions(logs, judged))
}

/** Returns the table of all rules that could run over one of [logs]; some of their findings are [judged]. */
internal fun fieldTable(logs: List<FieldLog>, judged: Map<Firing, Judgement>): String {
    val rows = RuleSet.BUILT_IN.rules.mapNotNull { rule ->
        val ran = logs.count { rule.name in it.ran }
        val found = logs.flatMap { log -> log.findings.filter { it.firing.rule == rule.name } }
        val counts = Judgement.entries.map { judgement -> found.count { judged[it.firing] == judgement } }
        val cells = listOf(ran, logs.count { log -> log.findings.any { it.firing.rule == rule.name } }, found.size) +
            counts + (found.size - counts.sum())
        if (ran == 0 && found.isEmpty()) null else "| ${rule.name} | ${cells.joinToString(" | ")} |"
    }
    return "${logs.size} logs\n\n| rule | could run | logs with a finding | findings | true | false | cannot be known | not judged |\n" +
        "|---|---|---|---|---|---|---|---|\n" + rows.joinToString("\n") + "\n"
}

/** The findings without a judgement, as lines of judgements to complete. */
private fun openQuestions(logs: List<FieldLog>, judged: Map<Firing, Judgement>): String = logs.flatMap { log ->
    log.findings.filter { it.firing !in judged }.map { "${lineOf(it.firing)}?\t${log.name}: ${it.severity.name.lowercase()}: ${it.text}" }
}.joinToString("\n", "\n", "\n")
