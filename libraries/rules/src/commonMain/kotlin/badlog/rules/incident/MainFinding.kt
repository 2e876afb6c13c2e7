package badlog.rules.incident

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.rules.worstFirst

/**
 * The most important of a log's findings, for readers with only a moment.
 *
 * @property finding the worst finding; of an incident, the last one in its sentences, to which the others led.
 * @property incident the incident that it belongs to; null if there is none.
 */
class MainFinding internal constructor(val finding: Finding, val incident: Incident?) {
    /** The finding to read first: the cause of the incident, or else [finding]. */
    val begin: Finding get() = incident?.sentences?.first()?.finding ?: finding
}

/**
 * Returns the worst of [findings] and of the [incidents] among them; null if nothing was found. A worse finding that belongs to no incident comes
 * before an incident.
 */
fun mainFinding(findings: List<Finding>, incidents: List<Incident>): MainFinding? {
    val worst: Severity = findings.maxOfOrNull { it.severity } ?: return null
    val incident = incidents.firstOrNull()?.takeIf { it.severity == worst }
    val finding = incident?.lastReported(worst) ?: incident?.first ?: findings.worstFirst().first()
    return MainFinding(finding, incident)
}

/** Returns the last finding of [severity] that its sentences report; one about the whole log comes before all others. */
private fun Incident.lastReported(severity: Severity): Finding? = sentences.map { it.finding }.filter { it.severity == severity }
    .maxByOrNull { if (it.time.isNaN()) Double.NEGATIVE_INFINITY else it.time }
