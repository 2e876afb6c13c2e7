package badlog.rules.standing

import badlog.rules.field.Judgement
import badlog.rules.field.fieldLogsIn
import badlog.rules.field.judgementsIn
import badlog.rules.hashesOfBuiltInRules
import java.io.File

/**
 * Makes the table of counts again, from which the standing of each built-in rule is computed. Arguments: the table, and for each set the logs
 * to count, empty to leave its rows as they are: the folder of real logs and the file of judgements, the folders of the second and the third
 * simulator, the seeds of this project's final set with commas between them; then how often each fault occurs in that, and the matches without a fault for each naming.
 */
internal fun main(arguments: Array<String>) {
    val (table, logs, judged, planted, third) = arguments
    val (seed, rounds, healthy) = arguments.drop(SEED)
    val made = LinkedHashMap<EvidenceSet, List<JudgedLog>>()
    if (logs.isNotEmpty()) made[EvidenceSet.REAL] = realLogs(File(logs), File(judged))
    if (planted.isNotEmpty()) made[EvidenceSet.PLANTED] = plantedLogs(File(planted))
    if (third.isNotEmpty()) made[EvidenceSet.THIRD] = thirdLogs(File(third))
    if (seed.isNotEmpty()) made[EvidenceSet.GENERATED] = generatedLogs(seed.split(',').map { it.toLong() }, rounds.toInt(), healthy.toInt())
    val hashes = hashesOfBuiltInRules()
    val file = File(table)
    val kept = ruleCountsIn(file.readText()).filter { it.set !in made && it.rule in hashes }
    val counts = kept + made.flatMap { (set, judgedLogs) -> countsOf(set, judgedLogs, hashes) }
    val order = hashes.keys.withIndex().associate { (at, rule) -> rule to at }
    file.writeText(textOf(counts.sortedWith(compareBy({ order.getValue(it.rule) }, { it.set }))))
    val current = counts.filter { it.hash == hashes[it.rule] }.groupBy { it.rule }
    for ((set, logs) in made) {
        for (log in logs) log.found.filter { it.judgement == Judgement.FALSE }.forEach { println("false, ${set.id}, ${log.name}: ${it.rule}: ${it.text}") }
    }
    for (rule in hashes.keys) println("$rule: ${lackingIn(current[rule].orEmpty()).joinToString("; ").ifEmpty { "proven" }}")
}

private fun realLogs(folder: File, judged: File): List<JudgedLog> {
    val judgements = judgementsIn(judged.readText())
    return fieldLogsIn(folder).map { log -> JudgedLog(log.name, log.team, log.ran, log.findings.map { JudgedFinding(it.firing.rule, it.text, judgements[it.firing]) }) }
}

private const val SEED = 5
