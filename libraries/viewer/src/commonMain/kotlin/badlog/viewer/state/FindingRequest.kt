package badlog.viewer.state

import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.viewer.choices.board.EvidenceOffer
import badlog.viewer.draw.mark.FindingPlace

/** A task about the findings of a log that only a shell can perform. */
sealed interface FindingRequest : Request {
    /**
     * Shows the evidence of a finding to which a person goes.
     *
     * @property place the place of the finding.
     * @property incident the incident that the finding is part of; null for none.
     * @property isWhole whether the person means all of [incident].
     * @property spoken the announcement of a screen reader after a key; null after a click.
     */
    data class Show(val place: FindingPlace<Finding>, val incident: Incident?, val isWhole: Boolean, val spoken: String? = null) :
        FindingRequest

    /** Announces that there is no finding to go to, or that the rules are still running. */
    object AnnounceNone : FindingRequest

    /** Adds the graphs that show [finding], and [incident] if it is part of one, to the board. */
    class Pin(val finding: Finding, val incident: Incident?) : FindingRequest

    /** Keeps the graphs that are shown for a finding on the board. */
    object Keep : FindingRequest

    /** Shows the graphs of [offer] beside the selected finding's graphs. */
    class Add(val offer: EvidenceOffer) : FindingRequest

    /** Shows the graph of [difference] over the last earlier match that has the compared number. */
    class Compare(val difference: Finding) : FindingRequest

    /** Runs the rules again. */
    object RunRules : FindingRequest

    /** Makes [topic] the signal [signal], and runs the rules again; if it cannot be that, [FindingAction.Refuse] says why. */
    class Assign(val signal: String, val topic: String) : FindingRequest

    /** Takes back the topic assigned to [signal], and runs the rules again. */
    class Forget(val signal: String) : FindingRequest

    /** Saves the signals that a person assigned as a file. */
    object SaveSignals : FindingRequest
}
