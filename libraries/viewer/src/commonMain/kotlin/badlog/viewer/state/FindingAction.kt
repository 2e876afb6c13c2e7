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
    class GoTo(val place: FindingPlace<Finding>, val incident: Incident?, val isWhole: Boolean = false) : FindingAction

    /** Goes [steps] places forward within the visited finding, or back if negative. */
    class StepWithin(val steps: Int) : FindingAction

    /** Selects [finding] without going there, as soon as it is known. */
    class Select(val finding: WantedFinding) : FindingAction

    /** Reports that the findings are known, perhaps including the wanted one. */
    object Know : FindingAction

    /** Searches the findings for [text]; an empty one shows all of them. */
    class Search(val text: String) : FindingAction

    /** Lists more findings. */
    object ListMore : FindingAction

    /** Lists only the first few findings. */
    object ListFew : FindingAction

    /** Resets the search and all unfolded parts, as for findings that are not known yet. */
    object Forget : FindingAction

    /** Shows the lines of code that log the missing signals with [library]. */
    class ShowLines(val library: LoggingLibrary) : FindingAction

    /** Sets the [reason] why a topic cannot be the signal for which it was chosen; null if it can. */
    class Refuse(val reason: String?) : FindingAction
}
