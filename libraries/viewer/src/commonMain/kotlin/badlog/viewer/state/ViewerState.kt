package badlog.viewer.state

import badlog.viewer.choices.board.BoardHistory

/**
 * The state of an open log: what a person has put together, where the person is, and which parts of panels are open. Immutable: [reduce]
 * returns the next one.
 *
 * @property place where the person is in the log.
 * @property board the graphs that the person put together, with what can be undone.
 * @property findings what is searched and unfolded in the findings.
 * @property stay whether the person stays at the end of the log.
 */
data class ViewerState(
    val place: Place,
    val board: BoardHistory,
    val findings: FindingsState = FindingsState(),
    val stay: Stay = Stay(),
) {
    internal fun at(place: Place) = copy(place = place)
}
