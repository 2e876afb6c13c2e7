package badlog.viewer.shown.finding

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.rules.incident.mainFinding
import badlog.viewer.draw.mark.FindingPlace

/**
 * Returns the step to the first thing to see among [findings] and [incidents], see [mainFinding]. Both begin with the worst. The result is
 * null if nothing was found. A finding about the whole log has the place NaN.
 */
fun firstStep(findings: List<Finding>, incidents: List<Incident>): FindingStep? {
    val first = mainFinding(findings, incidents) ?: return null
    first.incident?.let(::stepTo)?.let { return it }
    return FindingStep(first.begin.firstPlace, first.incident)
}

/** Returns the step to the start of [incident]; null if all of it is about the whole log. */
internal fun stepTo(incident: Incident): FindingStep? = (listOf(incident.first) + incident.sentences.map { it.finding })
    .firstOrNull { it.time.isFinite() }?.let { FindingStep(it.firstPlace, incident) }

/** The place of the finding to look at first; NaN for a finding about the whole log. */
val Finding.firstPlace: FindingPlace<Finding> get() = FindingPlace(this, severity, places.firstOrNull() ?: Span(Double.NaN, Double.NaN))
