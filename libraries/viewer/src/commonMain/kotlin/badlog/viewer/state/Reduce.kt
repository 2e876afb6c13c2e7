package badlog.viewer.state

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.board.mergedWith
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.input.KeyAction
import badlog.viewer.shown.cursor.Cursors

/** Returns the outcome of [action] from [state], for a log with the content [shown]. It is the same on the page and in the window. */
fun reduce(state: ViewerState, shown: Shown, action: Action): Outcome = when (action) {
    is Action.Press -> if (shown.isOpen || action.key == KeyAction.CURSOR_VALUES) state.after(shown, action.key) else Outcome(state)

    is Action.Ask -> Outcome(state, action.request.takeIf { shown.isOpen || it is FolderRequest || it is Request.Copy })

    is Action.Unfold -> Outcome(state.copy(unfolded = state.unfolded + (action.fold to action.isOpen)))

    is Action.Measure -> Outcome(state.copy(statistics = action.statistics))

    is FindingAction -> state.after(shown, action)

    is BoardAction -> state.after(shown, action)

    is PlaceAction -> Outcome(state.after(shown, action))

    is FolderAction.MeasureAcross -> Outcome(state.copy(across = action.state))

    // The list of logs has a state of its own, which outlives the open log.
    is FolderAction -> Outcome(state)
}

private fun ViewerState.after(shown: Shown, key: KeyAction): Outcome = when (key) {
    KeyAction.PREVIOUS_SAMPLE -> stepped(shown, -1)
    KeyAction.NEXT_SAMPLE -> stepped(shown, 1)
    KeyAction.TEN_SAMPLES_BACK -> stepped(shown, -KeyAction.MANY_SAMPLES)
    KeyAction.TEN_SAMPLES_ON -> stepped(shown, KeyAction.MANY_SAMPLES)
    KeyAction.SECOND_CURSOR -> Outcome(at(place.run { copy(cursors = cursors.withSecond()) }), Request.Cursor)
    KeyAction.ZOOM_IN -> showing { zoomed(1, place.cursors.x) }
    KeyAction.ZOOM_OUT -> showing { zoomed(-1, place.cursors.x) }
    KeyAction.SHOW_ALL -> showing { reset() }
    KeyAction.PREVIOUS_VIEW -> showing { back() }
    KeyAction.NEXT_VIEW -> showing { forward() }
    KeyAction.SHOW_ENABLED -> showing { showingEnabled(shown.enabled) }
    KeyAction.PAN_LEFT -> showing { panned(-KeyAction.PAN_SHARE) }
    KeyAction.PAN_RIGHT -> showing { panned(KeyAction.PAN_SHARE) }
    KeyAction.NEXT_FINDING -> nextFinding(shown, 1)
    KeyAction.PREVIOUS_FINDING -> nextFinding(shown, -1)
    KeyAction.MOVE_UP -> moved(shown, -1)
    KeyAction.MOVE_DOWN -> moved(shown, 1)
    KeyAction.MOVE_TO_TOP -> moved(shown, -shown.graphs.graphs.size)
    KeyAction.NEXT_HEIGHT -> resized(shown)
    KeyAction.UNDO -> taking(shown, board.undone())
    KeyAction.REDO -> taking(shown, board.redone())
    KeyAction.PIN -> Outcome(this, Request.Pin)
    KeyAction.NEXT_LAYOUT -> Outcome(this, Request.Layout(1))
    KeyAction.PREVIOUS_LAYOUT -> Outcome(this, Request.Layout(-1))
    KeyAction.CURSOR_VALUES -> Outcome(this, Request.Values)
    KeyAction.MODULES -> Outcome(this, Request.Modules)
    KeyAction.NEW_FORMULA -> Outcome(this, Request.Formula)
    KeyAction.NEW_NOTE -> Outcome(this, Request.Note(place.ofNote))
    KeyAction.MARK -> Outcome(this, Request.Mark(shown.newest ?: place.ofNote))
    KeyAction.PREVIOUS_FRAME -> Outcome(this, Request.Frames(-1))
    KeyAction.NEXT_FRAME -> Outcome(this, Request.Frames(1))
}

private fun ViewerState.showing(step: Viewport.() -> Viewport) = Outcome(range(step))

/** Moves a cursor by [count] samples, or to the sample nearest to the middle of the visible range. Shows the cursor. */
private fun ViewerState.stepped(shown: Shown, count: Int): Outcome {
    val start = shown.samples.nearest(place.range.visible.run { (from + to) / 2 })
    if (start.isNaN()) return Outcome(this)
    val cursors = place.cursors.moved(start) { shown.samples.from(it, count) }
    val range = cursors.moving?.let(place.range::revealing) ?: place.range
    return Outcome(at(place.copy(range = range, cursors = cursors)), Request.Cursor)
}

private fun ViewerState.moved(shown: Shown, places: Int): Outcome {
    val graph = shown.graph ?: return Outcome(this)
    return taking(shown, board.changed(shown.graphs.moved(graph, places), shown.graphs), moved = graph)
}

private fun ViewerState.resized(shown: Shown): Outcome {
    val graph = shown.graphs.graphs.find { it.id == shown.graph } ?: return Outcome(this)
    return taking(shown, board.changed(shown.graphs.resized(graph.id, GraphHeight.of(graph.height).next.pixels), shown.graphs))
}

/** Returns the state after [action], for a log with the content [shown]. */
internal fun ViewerState.after(shown: Shown, action: PlaceAction): ViewerState = when (action) {
    is PlaceAction.Open -> copy(place = Place(Viewport(action.full)), following = EndFollowing())
    is PlaceAction.Grow -> grown(action)
    PlaceAction.GoToEnd -> place.atEnd().let { copy(place = it, following = if (shown.newest == null) following else following.begun(it)) }
    PlaceAction.FollowEnd -> at(place.movedToEnd())
    PlaceAction.Pause -> copy(following = following.paused(place))
    is PlaceAction.GoTo -> at(action.run { if (isWithSurroundings) place.at(x, Span(x, x)) else place.at(x) })
    is PlaceAction.Visit -> at(place.copy(visited = action.finding))
    is PlaceAction.Show -> range { showing(action.from, action.to) }
    PlaceAction.ShowSelection -> place.selection?.let { range { showing(it.from, it.to) } } ?: this
    PlaceAction.Remember -> range { remembered() }
    is PlaceAction.Move -> range { moved(action.from, action.to) }
    is PlaceAction.Shift -> range { shifted(action.distance) }
    is PlaceAction.Scale -> range { scaled(action.factor, action.center) }
    is PlaceAction.Range -> range { action.range }
    is PlaceAction.Select -> at(place.copy(selection = action.span))
    is PlaceAction.Hover -> cursors { hovering(place.within(action.x)) }
    PlaceAction.Leave -> cursors { left() }
    is PlaceAction.Click -> clicked(action)
    is PlaceAction.Pick -> range { if (action.x in visible) this else centered(action.x) }.cursors { pinnedAt(action.x) }
    is PlaceAction.Pin -> cursors { Cursors(place.within(action.x), action.second?.let(place::within)) }
    is PlaceAction.MoveCursor -> cursors { if (isPinned) pinnedAt(action.x) else hovering(action.x) }
    is PlaceAction.Point -> cursors { action.cursors }
    PlaceAction.Cancel -> at(place.cancelled())
}

/** Changes the visible range by [step]. */
internal fun ViewerState.range(step: Viewport.() -> Viewport): ViewerState = at(place.copy(range = place.range.step()))

private fun ViewerState.cursors(step: Cursors.() -> Cursors) = at(place.copy(cursors = place.cursors.step()))

private fun ViewerState.clicked(click: PlaceAction.Click): ViewerState {
    val x = place.within(click.x)
    return cursors { if (click.isShifted) shiftClicked(x, click.reach) else clicked(x, click.reach) }
}

private fun ViewerState.grown(log: PlaceAction.Grow): ViewerState {
    val stayed = following.grown(place, if (log.isOtherAxis) Place(Viewport(log.full)) else place.copy(range = place.range.grown(log.full)))
    return copy(place = stayed.place, following = stayed.following)
}

private fun Viewport.centered(x: Double) = showing(x - visible.width / 2, x + visible.width / 2)

private fun Place.within(x: Double) = x.coerceIn(range.full.from, range.full.to)

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

/** Returns the outcome of [action] from this state, for a log with the content [shown]. */
internal fun ViewerState.after(shown: Shown, action: FindingAction): Outcome = when (action) {
    is FindingAction.GoTo -> visiting(action.place, FindingRequest.Show(action.place, action.incident, action.isWhole))
    is FindingAction.StepWithin -> steppedWithin(shown, action.steps)
    is FindingAction.Select -> Outcome(at(place.copy(wanted = action.finding)).selected(shown))
    FindingAction.Know -> Outcome(selected(shown))
    is FindingAction.Search -> findings { copy(query = action.text, listed = null) }
    FindingAction.ListMore -> findings { copy(listed = (listed ?: 0) + FINDINGS_AT_A_TIME) }
    FindingAction.ListFew -> findings { copy(listed = null) }
    FindingAction.Forget -> Outcome(copy(findings = FindingsState(library = findings.library), unfolded = emptyMap()))
    is FindingAction.ShowLines -> findings { copy(library = action.library) }
    is FindingAction.Refuse -> findings { copy(refusal = action.reason) }
}

/** Goes to the step [steps] after the visited finding, in the order of keys. */
internal fun ViewerState.nextFinding(shown: Shown, steps: Int): Outcome {
    val step = shown.found?.order?.beside(place.visited?.finding, place.cursors.x ?: Double.NaN, steps)
    if (step == null) return Outcome(this, FindingRequest.AnnounceNone)
    return visiting(step.place, FindingRequest.Show(step.place, step.incident, step.incident != null, step.spoken))
}

private fun ViewerState.findings(step: FindingsState.() -> FindingsState) = Outcome(copy(findings = findings.step()))

private fun ViewerState.selected(shown: Shown): ViewerState {
    val (rule, topic, x) = place.wanted ?: return this
    fun isSelected(finding: Finding) = finding.rule == rule && finding.topic == topic
    val found = shown.found?.timeline?.placeAt(x, ::isSelected)?.takeIf { isSelected(it.finding) } ?: return this
    return at(place.copy(visited = found, wanted = null))
}

private fun ViewerState.steppedWithin(shown: Shown, steps: Int): Outcome {
    val visited = place.visited ?: return Outcome(this)
    val next = shown.found?.timeline?.within(visited.finding, visited.span.from, steps) ?: return Outcome(this)
    return visiting(next, FindingRequest.Show(next, shown.found?.incidentOf(next.finding), isWhole = false))
}

private fun ViewerState.visiting(goal: FindingPlace<Finding>, request: Request) = Outcome(at(place.visiting(goal)), request)

/** The number of findings beside incidents that are listed until a person asks for more. */
internal const val FEW_FINDINGS = 5

/** The number of findings that are added to the list at a time. */
internal const val FINDINGS_AT_A_TIME = 300
