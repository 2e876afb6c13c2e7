package badlog.viewer.state

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.BoardHistory

/**
 * The state of an open log: what a person has put together, where the person is, and which parts of panels are open. Immutable: [reduce]
 * returns the next one.
 *
 * @property place where the person is in the log.
 * @property board the graphs that the person put together, with what can be undone.
 * @property findings what is searched and unfolded in the findings.
 * @property added each graph added to show a finding, in its original form, except those that a person keeps: undoing also brings back
 *   those of previous findings.
 * @property stay whether the person stays at the end of the log.
 */
data class ViewerState(
    val place: Place,
    val board: BoardHistory,
    val findings: FindingsState = FindingsState(),
    val added: Set<BoardGraph> = emptySet(),
    val stay: Stay = Stay(),
) {
    /** All graphs that the person arranged, also those that the open log cannot draw. */
    val arranged: Board get() = Board(board.now.graphs - added)

    private val ofEvidence: Set<Int> get() = board.now.graphs.filter { it in added }.mapTo(HashSet()) { it.id }

    /** Returns those of the [drawn] graphs that were put on top to show a finding, unless the person has changed them. */
    fun evidenceIn(drawn: Board): Board = ofEvidence.let { ids -> Board(drawn.graphs.filter { it.id in ids }) }

    /** Returns the other [drawn] graphs: those that the person arranged. */
    internal fun arrangedIn(drawn: Board): Board = ofEvidence.let { ids -> Board(drawn.graphs.filter { it.id !in ids }) }

    internal fun at(place: Place) = copy(place = place)
}
