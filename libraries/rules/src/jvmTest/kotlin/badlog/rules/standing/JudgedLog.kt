package badlog.rules.standing

import badlog.rules.field.Judgement

/** A finding of [rule], and the judgement of it; null if it was not judged. */
internal class JudgedFinding(val rule: String, val text: String, val judgement: Judgement?)

/**
 * A log in which the findings of the built-in rules were judged.
 *
 * @property team its team; null for a simulated robot.
 * @property ran the names of the rules that could run.
 */
internal class JudgedLog(val name: String, val team: String?, val ran: Set<String>, val found: List<JudgedFinding>)

/** Returns the counts of each rule of [hashes] that could run over one of [logs], or found something there. */
internal fun countsOf(set: EvidenceSet, logs: List<JudgedLog>, hashes: Map<String, String>): List<RuleCounts> = hashes.mapNotNull { (rule, hash) ->
    val ran = logs.filter { rule in it.ran }
    val found = logs.flatMap { it.found }.filter { it.rule == rule }.map { it.judgement }
    if (ran.isEmpty() && found.isEmpty()) return@mapNotNull null
    val (right, wrong, unknown) = Judgement.entries.map { judgement -> found.count { it == judgement } }
    RuleCounts(rule, hash, set, ran.size, ran.mapNotNull { it.team }.distinct().size, found.size, right, wrong, unknown)
}

/** Returns these counts, in which [made] replaces the counts of [rules] in the same sets. */
internal fun List<RuleCounts>.recounted(made: Map<EvidenceSet, List<RuleCounts>>, rules: Set<String>): List<RuleCounts> = filter { it.set !in made || it.rule !in rules } + made.values.flatten()
