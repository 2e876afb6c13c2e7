package badlog.rules.confusion

import badlog.core.analysis.LogView
import badlog.core.bag.RecordingParser
import badlog.core.recording.Severity
import badlog.formats.LOG_FORMATS
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.incident.incidentsIn
import badlog.rules.over
import badlog.rules.worstFirst
import badlog.signals.withSignals

/**
 * An accusation: an incident, or a finding of severity error or warning.
 *
 * @property text everything that it says.
 * @property topics the full names of the topics that are to show it.
 */
internal class Claim(val text: String, val topics: List<String>, val isIncident: Boolean)

/**
 * Returns the claims of the built-in rules about the log [bytes], in the order of their list. Incidents are first, then findings, the worst
 * first.
 */
internal fun claimsAbout(bytes: ByteArray, file: String): List<Claim> {
    val parser = RecordingParser(LOG_FORMATS, bytes.size.toLong())
    parser.accept(bytes)
    val rules = RuleSet.BUILT_IN
    val view = LogView.of(parser.finish()).withSignals(rules.signals, file)
    val findings = rules.over(view, file).findings
    val incidents = rules.incidentsIn(findings).map { incident ->
        Claim(incident.sentences.joinToString(" ") { it.text }, incident.evidence, isIncident = true)
    }
    return incidents + findings.filter { it.severity != Severity.NOTE }.worstFirst().map {
        Claim("${it.rule}. ${it.text}", it.evidence, isIncident = false)
    }
}
