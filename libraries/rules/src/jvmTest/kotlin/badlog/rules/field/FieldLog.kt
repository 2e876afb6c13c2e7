package badlog.rules.field

import badlog.core.analysis.LogView
import badlog.core.bag.RecordingParser
import badlog.core.recording.Severity
import badlog.expression.LogViewSignals
import badlog.formats.LOG_FORMATS
import badlog.rules.Finding
import badlog.rules.HEARD_RULES
import badlog.rules.over
import badlog.signals.withSignals
import java.io.File
import java.security.MessageDigest
import java.util.concurrent.atomic.AtomicInteger
import kotlin.math.roundToLong

/**
 * Where a rule found something.
 *
 * @property log the beginning of the log's hash.
 * @property second the second of the first place; null for the whole log.
 */
internal data class Firing(val log: String, val rule: String, val second: Long?)

/** A finding in a real log. */
internal class FieldFinding(val firing: Firing, val severity: Severity, val text: String)

/**
 * The findings of the built-in rules in a log that another team published.
 *
 * @property team the folder that it is in, which stands for a team.
 * @property ran the names of the rules that could run; none of a simulated robot, where silence proves nothing.
 */
internal class FieldLog(val name: String, val team: String, val ran: Set<String>, val findings: List<FieldFinding>)

/** The built-in rules that could run over the log in some bytes, and their findings. None if the robot was never enabled. */
internal class RulesOverLog(val ran: Set<String>, val isSimulated: Boolean, val findings: List<Finding>)

/** Returns the findings in the log [bytes] called [name]; null if it is not a log. */
internal fun rulesOver(bytes: ByteArray, name: String): RulesOverLog? {
    val parser = RecordingParser(LOG_FORMATS, bytes.size.toLong())
    parser.accept(bytes)
    val recording = parser.finish()
    if (!recording.isReadable) return null
    val rules = HEARD_RULES
    val view = LogView.of(recording).withSignals(rules.signals, name)
    val result = rules.over(view, name)
    val skipped = result.skipped.mapTo(HashSet()) { it.rule }
    val wasEnabled = LogViewSignals(view).enabled?.isNotEmpty() != false
    val ran = if (wasEnabled) rules.rules.map { it.name }.filterTo(LinkedHashSet()) { it !in skipped } else emptySet()
    return RulesOverLog(ran, result.skipped.any { it.simulated != null }, result.findings)
}

/**
 * Returns the logs in [folder]. Each of its folders is one team's. Logs in a folder called `simulated` are of a simulated robot, even where
 * the log does not show it.
 */
internal fun fieldLogsIn(folder: File): List<FieldLog> {
    require(folder.isDirectory) { "There is no folder $folder. Give the folder of real logs with -Plogs=FOLDER." }
    val files = folder.walkTopDown().filter { it.isFile && it.extension in ENDINGS }.sorted().toList()
    val done = AtomicInteger()
    return files.parallelStream().map { file ->
        val path = file.relativeTo(folder).invariantSeparatorsPath.split('/').dropLast(1)
        fieldLogOf(file.readBytes(), file.name, path.firstOrNull().orEmpty(), SIMULATED in path).also {
            if (done.incrementAndGet() % REPORTED == 0) System.err.println("$done of ${files.size} logs")
        }
    }.toList().filterNotNull()
}

/** Returns the findings in the log [bytes] called [name], of [team]; null if it is not a log. */
internal fun fieldLogOf(bytes: ByteArray, name: String, team: String = "", isSimulated: Boolean = false): FieldLog? {
    val result = rulesOver(bytes, name) ?: return null
    val hash = MessageDigest.getInstance("SHA-256").digest(bytes).take(HASH_BYTES).joinToString("") { "%02x".format(it) }
    val findings = result.findings.map { finding ->
        val second = finding.time.takeIf { it.isFinite() }?.roundToLong()
        FieldFinding(Firing(hash, finding.rule, second), finding.severity, finding.text)
    }
    return FieldLog(name, team, if (isSimulated || result.isSimulated) emptySet() else result.ran, findings)
}

private const val SIMULATED = "simulated"
private val ENDINGS = setOf("wpilog", "bag", "badbag", "dslog", "dsevents", "revlog", "csv")
private const val REPORTED = 50
private const val HASH_BYTES = 8
