package badlog.viewer.state

import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.signals.logging.LoggingLibrary
import badlog.viewer.choices.board.Board
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.input.KeyAction

/** An action of a person, a file or a clock: the only thing that changes a [ViewerState]. */
sealed interface Action {
    /** A person presses [key], or a button that does the same. */
    class Press(val key: KeyAction) : Action

    /** Unfolds the part of a panel with the key [fold], or folds it. */
    class Unfold(val fold: String, val isOpen: Boolean) : Action

    /** Chooses the range of [statistics], and the order of channels. */
    class Measure(val statistics: StatisticsState) : Action

    /** Asks for a [Request], which only the shell can perform. */
    data class Ask(val request: Request) : Action
}

/** An action that changes the graphs of the board, besides keys. */
sealed interface BoardAction : Action {
    /** Begins with [board], without a history, as for another log. Then shows [visited], the board of a link, if there is one. */
    class Begin(val board: Board, val visited: Board? = null) : BoardAction

    /** Begins with [board] instead of the graphs that a person arranged; those that show a finding stay above it. */
    class BeginBelowEvidence(val board: Board) : BoardAction

    /** Begins with [drawn], graphs that can be drawn, unless a person has changed something. The new ones among them show a finding. */
    class BeginWithEvidence(val drawn: Board) : BoardAction

    /** Shows [board], the board of a link. Undoing brings back the person's own board, which stays remembered until a change. */
    class Visit(val board: Board) : BoardAction

    /** Shows [board] instead of all graphs; can be undone. */
    class ShowAll(val board: Board) : BoardAction

    /** Shows [board] instead of the graphs that are drawn; can be undone. */
    class Show(val board: Board) : BoardAction

    /** Takes back the change from the graphs [before] to [after]; later changes stay. */
    class Revert(val before: Board, val after: Board) : BoardAction

    /** Renames the line [line] to [name], also in the boards that undoing restores. */
    class Rename(val line: String, val name: String) : BoardAction

    /** Removes [lines], which can no longer be drawn, also from the boards that undoing restores. */
    class Forget(val lines: Set<String>) : BoardAction

    /** Shows [board] above all other graphs. It replaces the unchanged graphs of the previous finding. */
    class ShowEvidence(val board: Board) : BoardAction

    /** Keeps graph [id], which shows a finding; null keeps all such graphs. They then count as arranged by a person. */
    class Keep(val id: Int? = null) : BoardAction
}

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
