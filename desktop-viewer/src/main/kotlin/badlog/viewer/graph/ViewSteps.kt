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

/** Moves the cursor by [samples] rows of the open recording, and shows where it is then. */
internal fun stepCursor(viewer: Viewer, samples: Int) {
    val positions = viewer.open?.positions?.takeIf { it.isNotEmpty() } ?: return
    val visible = viewer.viewport.visible
    val cursor = viewer.cursor ?: (visible.from + visible.width / 2)
    val found = positions.binarySearch(cursor)
    val next = when {
        found >= 0 -> found + samples

        // Between two rows, the first step leads to the next one.
        samples > 0 -> -found - 1 + samples - 1

        else -> -found - 1 + samples
    }
    val x = positions[next.coerceIn(positions.indices)]
    viewer.cursor = x
    viewer.isCursorPinned = true
    viewer.viewport = viewer.viewport.revealing(x)
}
