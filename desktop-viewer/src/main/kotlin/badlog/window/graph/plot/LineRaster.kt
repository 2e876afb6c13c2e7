package badlog.window.graph.plot

import badlog.viewer.draw.plot.Plot
import badlog.viewer.draw.plot.drawLines
import badlog.window.pen.SkiaPen
import org.jetbrains.skia.Image
import org.jetbrains.skia.Surface
import kotlin.math.roundToInt

/**
 * Returns an image of the lines of [plot], which was made for [request]; null if there are none. Without a graphics card, long strokes are
 * most of the work of a frame. They are therefore drawn here, on the thread that makes the picture, and the window only copies the image.
 */
internal fun rasterOf(request: PlotRequest, plot: Plot): Image? {
    val frame = request.frame.part(0.0, 1 - plot.laneShare)
    val rows = frame.height.roundToInt()
    if (plot.lines.isEmpty() || rows < 1) return null
    return Surface.makeRasterN32Premul(request.width, rows).use { surface ->
        SkiaPen(surface.canvas, request.density.toDouble()).drawLines(frame, plot.lines, plot.axes, plot.isFilled, request.palette.pen)
        surface.makeImageSnapshot()
    }
}
