package badlog.viewer.session

import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.range.Viewport
import badlog.viewer.input.Action

/** Returns what [action] leads to, on the page and in the window, where [session] is shown of a log that is [shown]. */
fun after(session: Session, shown: Shown, action: Action): Outcome = when (action) {
    Action.PREVIOUS_SAMPLE -> session.stepped(shown, -1)
    Action.NEXT_SAMPLE -> session.stepped(shown, 1)
    Action.TEN_SAMPLES_BACK -> session.stepped(shown, -Action.MANY_SAMPLES)
    Action.TEN_SAMPLES_ON -> session.stepped(shown, Action.MANY_SAMPLES)
    Action.SECOND_CURSOR -> Outcome(session.at(session.place.run { copy(cursors = cursors.withSecond()) }), Request.Cursor)
    Action.ZOOM_IN -> session.showing { zoomed(1, session.place.cursors.x) }
    Action.ZOOM_OUT -> session.showing { zoomed(-1, session.place.cursors.x) }
    Action.SHOW_ALL -> session.showing { reset() }
    Action.PREVIOUS_VIEW -> session.showing { back() }
    Action.NEXT_VIEW -> session.showing { forward() }
    Action.SHOW_ENABLED -> session.showing { showingEnabled(shown.enabled) }
    Action.PAN_LEFT -> session.showing { panned(-Action.PAN_SHARE) }
    Action.PAN_RIGHT -> session.showing { panned(Action.PAN_SHARE) }
    Action.NEXT_FINDING -> session.visiting(shown, 1)
    Action.PREVIOUS_FINDING -> session.visiting(shown, -1)
    Action.MOVE_UP -> session.moved(-1)
    Action.MOVE_DOWN -> session.moved(1)
    Action.MOVE_TO_TOP -> session.moved(-session.graphs.graphs.size)
    Action.NEXT_HEIGHT -> session.resized()
    Action.UNDO -> Outcome(session.with(session.board.undone()))
    Action.REDO -> Outcome(session.with(session.board.redone()))
    Action.PIN -> Outcome(session, Request.Pin)
    Action.NEXT_LAYOUT -> Outcome(session, Request.Layout(1))
    Action.PREVIOUS_LAYOUT -> Outcome(session, Request.Layout(-1))
    Action.CURSOR_VALUES -> Outcome(session, Request.Values)
    Action.MODULES -> Outcome(session, Request.Modules)
    Action.NEW_FORMULA -> Outcome(session, Request.Formula)
    Action.NEW_NOTE -> Outcome(session, Request.Note(session.place.ofNote))
    Action.MARK -> Outcome(session, Request.Mark(shown.newest ?: session.place.ofNote))
    Action.PREVIOUS_FRAME -> Outcome(session, Request.Frames(-1))
    Action.NEXT_FRAME -> Outcome(session, Request.Frames(1))
}

private fun Session.showing(step: Viewport.() -> Viewport) = Outcome(at(place.copy(range = place.range.step())))

/** Moves a cursor by [count] samples, or to the sample nearest to the middle of what is visible, and shows it. */
private fun Session.stepped(shown: Shown, count: Int): Outcome {
    val start = shown.samples.nearest(place.range.visible.run { (from + to) / 2 })
    if (start.isNaN()) return Outcome(this)
    val cursors = place.cursors.moved(start) { shown.samples.from(it, count) }
    val range = cursors.moving?.let(place.range::revealing) ?: place.range
    return Outcome(at(place.copy(range = range, cursors = cursors)), Request.Cursor)
}

private fun Session.visiting(shown: Shown, steps: Int): Outcome {
    val step = shown.findings?.beside(place.visited?.finding, place.cursors.x ?: Double.NaN, steps)
    if (step == null) return Outcome(this, Request.NoFinding)
    return Outcome(at(place.visiting(step.place)), Request.Finding(step))
}

private fun Session.moved(places: Int): Outcome =
    if (graph == null) Outcome(this) else Outcome(changed(graphs.moved(graph, places)), Request.Graph(graph))

private fun Session.resized(): Outcome {
    val resized = graphs.graphs.find { it.id == graph } ?: return Outcome(this)
    return Outcome(changed(graphs.resized(resized.id, GraphHeight.of(resized.height).next.pixels)))
}
