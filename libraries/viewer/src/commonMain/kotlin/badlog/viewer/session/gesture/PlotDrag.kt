package badlog.viewer.session.gesture

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import badlog.viewer.input.DragKind
import badlog.viewer.state.PlaceAction

/**
 * A drag over a plot.
 *
 * @property startX the x of its start.
 * @property startY the distance of its start from the top of the lines, as a fraction of their height.
 * @property before the visible range at its start.
 * @property x the current x.
 * @property y the current fraction.
 */
data class PlotDrag(
    val kind: DragKind,
    val startX: Double,
    val startY: Double,
    val before: Viewport,
    val x: Double = startX,
    val y: Double = startY,
) {
    /** The dragged range of x. */
    val xSpan: Span get() = Span(minOf(startX, x), maxOf(startX, x))

    /** The dragged part of the lines' height, from the top. */
    val ySpan: Span get() = Span(minOf(startY, y), maxOf(startY, y))

    /** The action that undoes the drag's changes so far; null if there are none. */
    val undoing: PlaceAction? get() = if (kind == DragKind.PAN) PlaceAction.Range(before) else null
}
