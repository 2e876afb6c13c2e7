package badlog.viewer.graph.plot

import badlog.analysis.PixelColumns
import badlog.analysis.Series
import badlog.analysis.Span
import badlog.plot.curve.Curve
import badlog.plot.curve.Scale
import badlog.plot.curve.Strokes

/**
 * The curve of a series, for whoever draws it: graphs are computed on several threads, a curve can be used by one at a time.
 *
 * @param holdsUntil until where the last value holds, if values do; see [Curve].
 */
internal class SharedCurve(series: Series, holdsUntil: Double?) {
    private val curve = Curve(series, holdsUntil)
    private var columns = PixelColumns(0)

    /** The strokes for [visible] on [width] pixels, y still as it was logged: its scale is known only when all lines of a graph are. */
    @Synchronized
    fun trace(visible: Span, width: Int): Strokes {
        if (columns.count != width) columns = PixelColumns(width)
        curve.draw(visible.from, visible.to, columns)
        return Strokes().apply { trace(curve, Scale.ofX(visible, width.toDouble()), Scale.NONE) }
    }
}
