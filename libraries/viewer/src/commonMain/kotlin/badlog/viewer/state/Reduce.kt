package badlog.viewer.state

import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.range.Viewport
import badlog.viewer.input.KeyAction

/** Returns the outcome of [action] from [state], for a log with the content [shown]. It is the same on the page and in the window. */
fun reduce(state: ViewerState, shown: Shown, action: Action): Outcome = when (action) {
    is Action.Press -> if (shown.isOpen || action.key == KeyAction.CURSOR_VALUES) state.after(shown, action.key) else Outcome(state)

    is Action.Ask -> if (shown.isOpen || action.request is FolderRequest) Outcome(state, action.request) else Outcome(state)

    is Action.Unfold -> Outcome(state.copy(unfolded = state.unfolded + (action.fold to action.isOpen)))

    is Action.Measure -> Outcome(state.copy(statistics = action.statistics))

    is FindingAction -> state.after(shown, action)

    is BoardAction -> state.after(shown, action)

    is PlaceAction -> Outcome(state.after(shown, action))

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
