package badlog.viewer.state

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import badlog.viewer.shown.cursor.Cursors

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
