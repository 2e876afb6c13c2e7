package badlog.viewer.graph.plot

import badlog.analysis.PixelColumns
import badlog.analysis.Series
import badlog.plot.curve.Curve

/**
 * The curve of a series, for whoever draws it: graphs are computed on several threads, a curve can be used by one at a time.
 *
 * @param holdsUntil until where the last value holds, if values do; see [Curve].
 */
internal class SharedCurve(series: Series, holdsUntil: Double?) {
    private val curve = Curve(series, holdsUntil)
    private var columns = PixelColumns(0)

    /** Finds the points from [from] to [to] on [width] pixels, and gives what [read] makes of them. */
    @Synchronized
    fun <T> draw(from: Double, to: Double, width: Int, read: (Curve) -> T): T {
        if (columns.count != width) columns = PixelColumns(width)
        curve.draw(from, to, columns)
        return read(curve)
    }
}
