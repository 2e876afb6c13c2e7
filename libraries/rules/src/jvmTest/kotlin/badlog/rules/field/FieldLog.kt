package badlog.rules.field

import badlog.core.analysis.LogView
import badlog.core.bag.RecordingParser
import badlog.core.recording.Severity
import badlog.formats.LOG_FORMATS
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.over
import badlog.signals.withSignals
import java.security.MessageDigest
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
 * What the built-in rules say of a real log.
 *
 * @property ran the names of the rules that could run.
 */
internal class FieldLog(val name: String, val ran: Set<String>, val findings: List<FieldFinding>)

/** Returns what the built-in rules say of the log [bytes] called [name]; null if it is not a log. */
internal fun fieldLogOf(bytes: ByteArray, name: String): FieldLog? {
    val parser = RecordingParser(LOG_FORMATS, bytes.size.toLong())
    parser.accept(bytes)
    val recording = parser.finish()
    if (!recording.isReadable) return null
    val rules = RuleSet.BUILT_IN
    val result = rules.over(LogView.of(recording).withSignals(rules.signals, name), name)
    val skipped = result.skipped.mapTo(HashSet()) { it.rule }
    val hash = hashOf(bytes)
    val findings = result.findings.map { finding ->
        val second = finding.time.takeIf { it.isFinite() }?.roundToLong()
        FieldFinding(Firing(hash, finding.rule, second), finding.severity, finding.text)
    }
    return FieldLog(name, rules.rules.map { it.name }.filterTo(LinkedHashSet()) { it !in skipped }, findings)
}

private fun hashOf(bytes: ByteArray) = MessageDigest.getInstance("SHA-256").digest(bytes).take(HASH_BYTES).joinToString("") { "%02x".format(it) }

private const val HASH_BYTES = 8
