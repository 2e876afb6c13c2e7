package badlog.viewer.view

import badlog.analysis.Span
import badlog.plot.gesture.DragKind
import badlog.plot.range.Viewport

/**
 * A drag over the graphs.
 *
 * @property graph over which graph it began; null for the axis and the overview.
 * @property startX where on x it began.
 * @property startY where on the left axis of that graph.
 * @property x where on x it is now.
 * @property y where on that axis.
 * @property before what was seen when it began.
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
    /** The part of x it has gone over. */
    val xSpan: Span get() = Span(minOf(startX, x), maxOf(startX, x))

    /** The part of y it has gone over. */
    val ySpan: Span get() = Span(minOf(startY, y), maxOf(startY, y))
}
