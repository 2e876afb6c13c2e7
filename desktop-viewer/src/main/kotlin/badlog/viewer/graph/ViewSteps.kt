package badlog.viewer.graph

import badlog.viewer.recording.CurrentRecording
import badlog.viewer.view.AxisView

/** Shows what is selected. */
internal fun zoomToSelection(view: AxisView) {
    val selection = view.selection ?: return
    view.change { showing(selection.from, selection.to) }
}

/** Moves the cursor by [samples] of the open recording, or to the one in the middle of the view, and shows where it is then. */
internal fun stepCursor(current: CurrentRecording, view: AxisView, samples: Int) {
    val steps = current.recording?.cursorSteps ?: return
    val visible = view.viewport.visible
    val x = view.cursor?.let { steps.from(it, samples) } ?: steps.nearest(visible.from + visible.width / 2)
    if (x.isNaN()) return
    view.goTo(x)
}
