package badlog.window.graph.plot

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes

/**
 * The curve of a series, shared by threads: graphs are computed on several threads, but a curve can be used by only one at a
 * time.
 *
 * @param holdsUntil until where the last value holds, if values do; see [Curve].
 */
internal class SharedCurve(series: Series, holdsUntil: Double?) {
    private val curve = Curve(series, holdsUntil)
    private var columns = PixelColumns(0)

    /** Returns the strokes for [visible] on [width] pixels, with y as logged: its scale is known only when all lines of a graph are. */
    @Synchronized
    fun trace(visible: Span, width: Int): Strokes {
        if (columns.count != width) columns = PixelColumns(width)
        curve.draw(visible.from, visible.to, columns)
        return Strokes().apply { trace(curve, Scale.ofX(visible, width.toDouble()), Scale.NONE) }
    }
}
