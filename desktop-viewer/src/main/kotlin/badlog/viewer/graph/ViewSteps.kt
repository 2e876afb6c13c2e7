package badlog.viewer.graph

import badlog.viewer.app.Viewer

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
