package badlog.rules.standing

import badlog.core.json.JsonReader
import badlog.rules.Finding
import badlog.rules.confusion.MatchSet
import badlog.rules.confusion.faultyMatches
import badlog.rules.confusion.healthyMatches
import badlog.rules.field.Judgement
import badlog.rules.field.rulesOver
import badlog.samples.generated.GeneratedMatch
import badlog.samples.generated.fault.Verdict
import badlog.signals.json.JsonFields
import java.io.File

/** Returns the matches of this project's final sets with [seeds], judged by the words that each fault accepts. */
internal fun generatedLogs(seeds: List<Long>, rounds: Int, healthy: Int): List<JudgedLog> {
    val matches = seeds.flatMap { faultyMatches(MatchSet.FINAL, it, rounds) + healthyMatches(MatchSet.FINAL, it, healthy) }
    return matches.parallelStream().map { make ->
        val match = make()
        judgedLog(match.bytes, match.fileName) { verdictOn(it, match) }
    }.toList().filterNotNull()
}

private fun verdictOn(finding: Finding, match: GeneratedMatch): Judgement {
    if (finding.rule in FACTS) return Judgement.TRUE
    val fault = match.fault ?: return Judgement.FALSE
    if (finding.rule in MESSAGES) return Judgement.TRUE
    val isShown = match.evidence.isEmpty() || finding.evidence.any { topic -> match.evidence.any(topic::startsWith) }
    return if (isShown && fault.verdictOn("${finding.rule}. ${finding.text}") != Verdict.OTHER) Judgement.TRUE else Judgement.FALSE
}

/** Returns the matches of the second simulator in [folder]; their names begin with the planted fault. */
internal fun plantedLogs(folder: File): List<JudgedLog> = logsIn(folder).parallelStream().map { file ->
    val right = rightRulesFor(file.name.takeWhile { it.isLetter() })?.plus(MESSAGES).orEmpty() + FACTS
    judgedLog(file.readBytes(), file.name) { if (it.rule in right) Judgement.TRUE else Judgement.FALSE }
}.toList().filterNotNull()

/**
 * Returns the matches of the third simulator in [folder] and below it. The `truth.json` of each names the planted faults and their times. Faults that
 * its author calls invisible still disturb the robot, so other rules' findings there are neither true nor false.
 */
internal fun thirdLogs(folder: File): List<JudgedLog> = folder.walkTopDown().filter { it.name == "truth.json" }.sorted().toList().flatMap { thirdLogsOf(it.parentFile) }

private fun thirdLogsOf(folder: File): List<JudgedLog> {
    val truth = JsonFields(JsonReader.readObject("{\"all\":${File(folder, "truth.json").readText()}}")).list("all") { JsonFields(it.members) }
    return truth.parallelStream().map { match ->
        val file = File(folder, match.string("file"))
        val fault = match.optional("fault")
        val from = match.find("at")?.json?.toDoubleOrNull()
        val right = if (from == null) emptySet() else rightRulesFor(fault.orEmpty())?.plus(MESSAGES).orEmpty()
        val other = if (fault == null || from == null || match.isTrue("visible")) Judgement.FALSE else Judgement.UNKNOWN
        judgedLog(file.readBytes(), file.name) { finding ->
            // A count of messages may include some from before the fault.
            val time = finding.spans.lastOrNull()?.to?.takeIf { finding.rule in MESSAGES } ?: finding.time
            val isAfter = time.isNaN() || time >= (from ?: 0.0) - BEFORE
            if (finding.rule in FACTS || (finding.rule in right && isAfter)) Judgement.TRUE else other
        }
    }.toList().filterNotNull()
}

/**
 * Returns the matches of the fifth simulator in [folder] and below it. The `truth.tsv` of each has the planted faults, their times, and two
 * expressions for a right finding: for the fault, and for the part. Both have to match the finding or its topics.
 */
internal fun fifthLogs(folder: File): List<JudgedLog> = folder.walkTopDown().filter { it.name == "truth.tsv" }.sorted().toList().flatMap { fifthLogsOf(it) }

private fun fifthLogsOf(truth: File): List<JudgedLog> = truth.readLines().drop(1).map { it.split('\t') }.parallelStream().map { row ->
    val fault = row[FIFTH_FAULT]
    val said = if (fault == "healthy") null else row.last().split(" ; ").map { Regex(it.trim()) }
    judgedLog(truth.resolveSibling(row.first()).readBytes(), row.first()) { finding ->
        val words = (listOf(finding.rule, finding.text) + finding.evidence).joinToString(" ").lowercase()
        val isRight = said != null && (finding.rule in MESSAGES || finding.rule in rightRulesFor(fault).orEmpty() || said.all { it.containsMatchIn(words) })
        val isBefore = finding.time < row[FIFTH_START].toDouble() - BEFORE
        if (finding.rule in FACTS || (isRight && !isBefore)) Judgement.TRUE else Judgement.FALSE
    }
}.toList().filterNotNull()

private const val FIFTH_FAULT = 2
private const val FIFTH_START = 3

private fun judgedLog(bytes: ByteArray, name: String, judgement: (Finding) -> Judgement): JudgedLog? = rulesOver(bytes, name)?.let { result -> JudgedLog(name, null, result.ran, result.findings.map { JudgedFinding(it.rule, it.text, judgement(it)) }) }

private fun logsIn(folder: File) = folder.walkTopDown().filter { it.isFile && it.extension in setOf("wpilog", "bag") }.sorted().toList()

/** Rules that look at the time around a sample find something this much earlier than it happened, in s. */
private const val BEFORE = 2.0
