package badlog.window.graph.plot

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes

/**
 * The curve of a series, shared by threads: only one thread at a time can use a curve.
 *
 * @param holdsUntil the x until which the last value holds, if values hold; see [Curve].
 */
internal class SharedCurve(series: Series, holdsUntil: Double?) {
    private val curve = Curve(series, holdsUntil)
    private var columns = PixelColumns(0)

    /** Returns the strokes for [visible] on [width] pixels, with y as logged. The scale of y depends on all lines of a graph. */
    @Synchronized
    fun trace(visible: Span, width: Int): Strokes {
        if (columns.count != width) columns = PixelColumns(width)
        curve.draw(visible.from, visible.to, columns)
        return Strokes().apply { trace(curve, Scale.ofX(visible, width.toDouble()), Scale.NONE) }
    }
}
