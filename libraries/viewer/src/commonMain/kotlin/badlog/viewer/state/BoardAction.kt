package badlog.viewer.state

import badlog.viewer.choices.board.Board

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
