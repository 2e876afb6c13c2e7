package badlog.viewer.session.gesture

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import badlog.viewer.input.DragKind
import badlog.viewer.state.PlaceAction

/**
 * A drag over a plot.
 *
 * @property startX the x at which it began.
 * @property startY how far below the top of the lines it began, as a fraction of their height.
 * @property before the visible range when it began.
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
    /** The range of x that it covers. */
    val xSpan: Span get() = Span(minOf(startX, x), maxOf(startX, x))

    /** The part of the height of the lines that it covers, from the top. */
    val ySpan: Span get() = Span(minOf(startY, y), maxOf(startY, y))

    /** What takes back what it has changed so far; null if that is nothing. */
    val undoing: PlaceAction? get() = if (kind == DragKind.PAN) PlaceAction.Range(before) else null
}
