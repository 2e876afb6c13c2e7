package badlog.viewer.state

import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.signals.logging.LoggingLibrary
import badlog.viewer.draw.mark.FindingPlace

/** An action of a person on the findings of a log. */
sealed interface FindingAction : Action {
    /**
     * Goes to a finding.
     *
     * @property place the place of the finding.
     * @property incident the incident that the finding is part of; null for none.
     * @property isWhole whether the person means all of [incident].
     */
    data class GoTo(val place: FindingPlace<Finding>, val incident: Incident?, val isWhole: Boolean = false) : FindingAction

    /** Goes [steps] places forward within the finding that was gone to, or back if negative. */
    data class StepWithin(val steps: Int) : FindingAction

    /** Searches the findings for [text]; an empty one shows all of them. */
    data class Search(val text: String) : FindingAction

    /** Lists more findings. */
    data object ListMore : FindingAction

    /** Lists only the first few findings. */
    data object ListFew : FindingAction

    /** Folds or unfolds the findings that incidents contain but do not mention. */
    data object ToggleWithin : FindingAction

    /** Folds or unfolds the rules that could not run. */
    data object ToggleSkipped : FindingAction

    /** Unfolds and searches nothing, as for findings that are not known yet. */
    data object Forget : FindingAction

    /** Shows the lines of [library] that log the missing signals. */
    data class ShowLines(val library: LoggingLibrary) : FindingAction

    /** Learns why a topic cannot be the signal that it was chosen for; null if it can. */
    data class Refuse(val reason: String?) : FindingAction
}
