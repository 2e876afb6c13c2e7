package badlog.page.graph

import badlog.analysis.Span
import badlog.plot.curve.Scale

/** Where x and y of a plot stand on its canvas. */
internal class PlotFrame(
    val left: Double,
    val top: Double,
    val width: Double,
    val height: Double,
    xFrom: Double,
    xTo: Double,
    yFrom: Double,
    yTo: Double,
) {
    val x: Scale = Scale.ofX(Span(xFrom, xTo), width, left)
    val y: Scale = Scale.ofY(Span(yFrom, yTo), height, top)
    val right: Double get() = left + width
    val bottom: Double get() = top + height

    /** The pixel of 0, or of the edge nearest to it: where a filled area ends. */
    val baseline: Double get() = y.placeOf(0.0).coerceIn(top, bottom)
}
