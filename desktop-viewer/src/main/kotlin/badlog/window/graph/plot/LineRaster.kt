package badlog.window.graph.plot

import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.drawLines
import badlog.window.pen.SkiaPen
import org.jetbrains.skia.Image
import org.jetbrains.skia.Surface

/**
 * Returns an image of the lines of [picture]; null if there are none. Without a graphics card, long strokes are most of the work of a frame,
 * so they are drawn here, on the thread that makes the picture, and the window only copies the image.
 */
internal fun rasterOf(picture: PlotPicture): Image? {
    val rows = picture.plotHeight.toInt()
    val request = picture.request
    if (picture.lines.isEmpty() || rows < 1) return null
    return Surface.makeRasterN32Premul(request.width, rows).use { surface ->
        val frame = PlotFrame(0.0, 0.0, request.width.toDouble(), picture.plotHeight.toDouble(), request.visible)
        val plot = picture.plot
        SkiaPen(surface.canvas, request.density.toDouble()).drawLines(frame, plot.lines, plot.axes, plot.isFilled, request.palette.pen)
        surface.makeImageSnapshot()
    }
}
