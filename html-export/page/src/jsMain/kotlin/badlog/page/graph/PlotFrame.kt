package badlog.page.graph

import badlog.core.analysis.Span
import badlog.viewer.draw.curve.Scale

/** Where a plot is on its canvas. */
internal class PlotFrame(val left: Double, val top: Double, val width: Double, val height: Double, xFrom: Double, xTo: Double) {
    val x: Scale = Scale.ofX(Span(xFrom, xTo), width, left)
    val right: Double get() = left + width
    val bottom: Double get() = top + height

    /** Returns the same frame, showing another part of x. */
    fun showing(x: Span): PlotFrame = PlotFrame(left, top, width, height, x.from, x.to)

    /** Returns the scale on which [shown] fills the frame. */
    fun scaleOf(shown: Span): Scale = Scale.ofY(shown, height, top)

    /** Returns the pixel of 0 on [y], or of the edge nearest to it: where a filled area ends. */
    fun baselineOf(y: Scale): Double = y.placeOf(0.0).coerceIn(top, bottom)
}
