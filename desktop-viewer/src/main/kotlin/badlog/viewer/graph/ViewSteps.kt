package badlog.viewer.graph

import badlog.viewer.app.Viewer

/** Shows the time from the first moment at which the robot was enabled to the last; nothing happens where nothing tells. */
internal fun zoomToEnabled(viewer: Viewer) {
    val enabled = viewer.open?.enabled.orEmpty()
    if (enabled.isEmpty()) return
    val from = enabled.minOf { it.span.from }
    val to = enabled.maxOf { it.span.to }
    if (to > from) viewer.viewport = viewer.viewport.showing(from, to)
}

/** Shows what is selected. */
internal fun zoomToSelection(viewer: Viewer) {
    val selection = viewer.selection ?: return
    viewer.viewport = viewer.viewport.showing(selection.from, selection.to)
}

/** Moves the cursor by [samples] of the open recording, or to the one in the middle of the view, and shows where it is then. */
internal fun stepCursor(viewer: Viewer, samples: Int) {
    val steps = viewer.open?.cursorSteps ?: return
    val visible = viewer.viewport.visible
    val x = viewer.cursor?.let { steps.from(it, samples) } ?: steps.nearest(visible.from + visible.width / 2)
    if (x.isNaN()) return
    viewer.cursor = x
    viewer.isCursorPinned = true
    viewer.viewport = viewer.viewport.revealing(x)
}
