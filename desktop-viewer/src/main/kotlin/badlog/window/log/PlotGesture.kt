package badlog.window.log

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import badlog.viewer.input.DragKind

/**
 * A drag over the graphs.
 *
 * @property graph the graph over which it began; null for the axis and the overview.
 * @property startX the x at which it began.
 * @property startY the value on the left axis of that graph at which it began.
 * @property x the current x.
 * @property y the current value on that axis.
 * @property before the viewport when it began.
 */
internal data class PlotGesture(
    val kind: DragKind,
    val graph: Int?,
    val startX: Double,
    val startY: Double,
    val before: Viewport,
    val x: Double = startX,
    val y: Double = startY,
) {
    /** The range of x it covers. */
    val xSpan: Span get() = Span(minOf(startX, x), maxOf(startX, x))

    /** The range of y it covers. */
    val ySpan: Span get() = Span(minOf(startY, y), maxOf(startY, y))
}
