package badlog.viewer.shown.finding

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.rules.incident.mainFinding
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.text.countText
import badlog.viewer.text.word

/**
 * A step of a person who goes through the findings with a key.
 *
 * @property place the target of the step.
 * @property incident the incident that begins there; null if the finding does not belong to one.
 */
class FindingStep(val place: FindingPlace<Finding>, val incident: Incident?) {
    /** The announcement of a screen reader: the whole incident, or the finding at the place. */
    val spoken: String
        get() = if (incident == null) {
            "${place.severity.word}: ${place.finding.rule}. ${place.finding.textAt(place.span)}"
        } else {
            "${incident.severity.word}: ${incident.sentences.joinToString(" ") { it.text }}"
        }
}

/**
 * The order in which keys go through the findings of [timeline]. The [incidents] are first, as they are listed; the other findings follow
 * in the order of time. Findings that begin at one moment are one step, to the worst of them.
 */
class FindingOrder(private val timeline: FindingTimeline<Finding>, incidents: List<Incident>) {
    private val ofIncidents = incidents.mapNotNull(::stepTo)
    private val ofAnyIncident = incidents.flatMapTo(HashSet()) { it.causes + it.effects }
    private val others = timeline.places.filter { it.finding !in ofAnyIncident }
        .groupBy { it.span.from }.values
        .map { ofInstant -> FindingStep(ofInstant.maxBy { it.severity }, incident = null) }
    private val all = ofIncidents + others

    /**
     * Returns the step that is [steps] after the one to [current], or before it if negative. If [current] is null, or outside incidents and
     * the cursor at [x] has left it, the steps are counted from x among the findings outside incidents. If x is NaN, or [current] is null
     * and there are incidents, they are counted from the start, or from the end if negative. They end at the first and last step; null if
     * there are none.
     */
    fun beside(current: Finding?, x: Double, steps: Int): FindingStep? {
        val index = all.indexOfFirst { step ->
            if (step.incident == null) {
                isAt(step, current, x)
            } else {
                current != null && current in step.incident
            }
        }
        val next = when {
            index >= 0 -> index + steps
            x.isNaN() || (current == null && ofIncidents.isNotEmpty()) -> if (steps > 0) steps - 1 else all.size + steps
            steps > 0 -> ofIncidents.size + others.count { it.place.span.from <= x } + steps - 1
            else -> ofIncidents.size + others.count { it.place.span.from < x } + steps
        }
        return all.getOrNull(next.coerceIn(0, maxOf(0, all.size - 1)))
    }

    private fun isAt(step: FindingStep, current: Finding?, x: Double) =
        current != null && step.place.span.from == x && current.places.any { it.from == x }
}

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

/**
 * The places of the finding in the order in which a person steps through them. That is the order of x, even if another place is the one to
 * look at first.
 */
val Finding.placesInOrder: List<Span> get() = places.sortedBy { it.from }

/**
 * Returns the number of [place] among the finding's places, such as `3 of 12`. It is for a person who steps through them. If the finding
 * occurred more often than at the known places, its count follows: `3 of 100, found 1200 times`. An unknown place counts as the first one.
 */
fun Finding.placeNumber(place: Span): String {
    val steps = placesInOrder
    val number = "${countText(maxOf(0, steps.indexOf(place)) + 1)} of ${countText(steps.size)}"
    return if (spanCount > steps.size) "$number, found ${countText(spanCount)} times" else number
}
