package badlog.rules.standing

import badlog.rules.field.Judgement
import badlog.rules.field.fieldLogsIn
import badlog.rules.field.judgementsIn
import badlog.rules.hashesOfBuiltInRules
import java.io.File

/**
 * Makes the table of counts again, from which the standing of each built-in rule is computed. Arguments: the table, and for each set the logs
 * to count, empty to leave its rows as they are: the folder of real logs and the file of judgements, the folders of the second, the third and
 * the fifth simulator, the seeds of this project's final set with commas between them; then how often each fault occurs in that, and the
 * matches without a fault for each naming. Last come the rules to count, with commas between them; empty for all.
 */
internal fun main(arguments: Array<String>) {
    val (table, logs, judged, planted, third) = arguments
    val (fifth, seed, rounds, healthy, chosen) = arguments.drop(FIFTH)
    val logsOf = LinkedHashMap<EvidenceSet, List<JudgedLog>>()
    if (logs.isNotEmpty()) logsOf[EvidenceSet.REAL] = realLogs(File(logs), File(judged))
    if (planted.isNotEmpty()) logsOf[EvidenceSet.PLANTED] = plantedLogs(File(planted))
    if (third.isNotEmpty()) logsOf[EvidenceSet.THIRD] = thirdLogs(File(third))
    if (fifth.isNotEmpty()) logsOf[EvidenceSet.FIFTH] = fifthLogs(File(fifth))
    if (seed.isNotEmpty()) logsOf[EvidenceSet.GENERATED] = generatedLogs(seed.split(',').map { it.toLong() }, rounds.toInt(), healthy.toInt())
    val hashes = hashesOfBuiltInRules()
    val rules = if (chosen.isEmpty()) hashes.keys else chosen.split(',').toSet()
    require(rules.all { it in hashes }) { "There are no rules ${rules - hashes.keys}." }
    val file = File(table)
    val made = logsOf.mapValues { (set, judgedLogs) -> countsOf(set, judgedLogs, hashes.filterKeys { it in rules }) }
    val counts = ruleCountsIn(file.readText()).filter { it.rule in hashes }.recounted(made, rules)
    val order = hashes.keys.withIndex().associate { (at, rule) -> rule to at }
    file.writeText(textOf(counts.sortedWith(compareBy({ order.getValue(it.rule) }, { it.set }))))
    val current = counts.filter { it.hash == hashes[it.rule] }.groupBy { it.rule }
    for ((set, judgedLogs) in logsOf) {
        for (log in judgedLogs) log.found.filter { it.judgement == Judgement.FALSE && it.rule in rules }.forEach { println("false, ${set.id}, ${log.name}: ${it.rule}: ${it.text}") }
    }
    for (rule in hashes.keys) println("$rule: ${lackingIn(current[rule].orEmpty()).joinToString("; ").ifEmpty { "proven" }}")
}

private fun realLogs(folder: File, judged: File): List<JudgedLog> {
    val judgements = judgementsIn(judged.readText())
    return fieldLogsIn(folder).map { log -> JudgedLog(log.name, log.team, log.ran, log.findings.map { JudgedFinding(it.firing.rule, it.text, judgements[it.firing]) }) }
}

private const val FIFTH = 5
