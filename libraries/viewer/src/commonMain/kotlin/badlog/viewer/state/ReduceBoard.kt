package badlog.viewer.state

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.board.mergedWith

/** Returns the outcome of [action] from this state, for a log with the content [shown]. */
internal fun ViewerState.after(shown: Shown, action: BoardAction): Outcome = when (action) {
    is GraphChange -> taking(shown, board.changed(shown.graphs.after(action), shown.graphs))
    is BoardAction.Begin -> Outcome(begun(action))
    is BoardAction.BeginBelowEvidence -> Outcome(begunBelowEvidence(shown.graphs, action.board))
    is BoardAction.BeginWithEvidence -> Outcome(if (board.canUndo) this else begunWithEvidence(shown.graphs, action.drawn))
    is BoardAction.Visit -> Outcome(copy(board = board.changed(action.board)))
    is BoardAction.ShowAll -> taking(shown, board.changed(action.board))
    is BoardAction.Show -> taking(shown, board.changed(action.board, shown.graphs))
    is BoardAction.Revert -> taking(shown, board.changed(action.before, action.after))
    is BoardAction.Rename -> everywhere(shown) { renamed(action.line, action.name) }
    is BoardAction.Forget -> everywhere(shown) { action.lines.fold(this, Board::withoutSignal) }
    is BoardAction.ShowEvidence -> Outcome(showingEvidence(shown.graphs, action.board))
    is BoardAction.Keep -> Outcome(copy(added = added - board.now.graphs.filter { action.id == null || it.id == action.id }.toSet()))
}

/** Goes to [to], the board with its history after a step; [moved] is the graph that a key has moved, if any. */
internal fun ViewerState.taking(shown: Shown, to: BoardHistory, moved: Int? = null): Outcome {
    val before = shown.graphs.takeIf { to !== board }
    return Outcome(copy(board = to), if (before == null && moved == null) null else Request.Graphs(before, moved))
}

private fun ViewerState.everywhere(shown: Shown, change: Board.() -> Board): Outcome {
    val next = copy(board = board.everywhere(change), added = Board(added.toList()).change().graphs.toSet())
    return Outcome(next, if (next.board.now == board.now) null else Request.Graphs(shown.graphs))
}

private fun ViewerState.begun(with: BoardAction.Begin): ViewerState {
    val own = board.begunWith(with.board)
    return copy(board = with.visited?.let(own::changed) ?: own, added = emptySet())
}

private fun ViewerState.begunBelowEvidence(drawn: Board, with: Board): ViewerState {
    val first = (with.graphs.maxOfOrNull { it.id } ?: 0) + 1
    val shown = evidenceIn(drawn).graphs.mapIndexed { i, graph -> graph.copy(id = first + i) }
    return copy(board = board.begunWith(Board(shown + with.graphs)), added = shown.toSet())
}

private fun ViewerState.begunWithEvidence(drawn: Board, with: Board): ViewerState {
    val ids = drawn.graphs.associate { it.lines to it.id }
    val known = Board(with.graphs.map { it.copy(id = ids[it.lines] ?: it.id) })
    val begun = board.begunWith(known.mergedWith(board.now, drawn))
    return copy(board = begun, added = known.graphs.filterNot { it.lines in ids }.toSet())
}

private fun ViewerState.showingEvidence(drawn: Board, shown: Board): ViewerState {
    if (evidenceIn(drawn).showsSame(shown)) return this
    val first = (board.now.graphs.maxOfOrNull { it.id } ?: 0) + 1
    val above = shown.graphs.mapIndexed { i, graph -> graph.copy(id = first + i) }
    val known = board.now.graphs.mapTo(HashSet()) { it.id }
    val changed = board.changed(Board(above + arrangedIn(drawn).graphs), drawn)
    return copy(board = changed, added = added + changed.now.graphs.filter { it.id !in known })
}
