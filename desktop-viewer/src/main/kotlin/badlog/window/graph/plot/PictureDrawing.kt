package badlog.window.graph.plot

import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.graphics.drawscope.drawIntoCanvas
import androidx.compose.ui.graphics.skiaCanvas
import badlog.core.analysis.Span
import badlog.viewer.draw.plot.PlotFrame
import org.jetbrains.skia.Rect
import org.jetbrains.skia.SamplingMode

/**
 * Draws the lines of [picture] within [frame]. A picture made for another part of x is stretched to fit, until the requested one is ready.
 */
internal fun DrawScope.drawLines(picture: PlotPicture, frame: PlotFrame) {
    val image = picture.image ?: return
    val made = picture.request.visible
    val left = frame.left.toFloat() + pixelOf(made.from, frame.shown, frame.width.toFloat())
    val right = frame.left.toFloat() + pixelOf(made.to, frame.shown, frame.width.toFloat())
    // A picture of a much larger or smaller range would show nothing.
    if (right - left !in frame.width / MAX_STRETCH..frame.width * MAX_STRETCH) return
    val whole = Rect.makeWH(image.width.toFloat(), image.height.toFloat())
    clipRect(left = frame.left.toFloat(), right = frame.right.toFloat()) {
        drawIntoCanvas { canvas ->
            canvas.skiaCanvas.drawImageRect(image, whole, Rect(left, 0f, right, image.height.toFloat()), SamplingMode.DEFAULT, null, true)
        }
    }
}

/** Returns the frame that fills this scope and shows [shown]. */
internal fun DrawScope.frameOf(shown: Span): PlotFrame = PlotFrame(0.0, 0.0, size.width.toDouble(), size.height.toDouble(), shown)

/** Returns the pixel of [x] on [width] pixels that show [visible]. */
internal fun pixelOf(x: Double, visible: Span, width: Float): Float = ((x - visible.from) / visible.width * width).toFloat()

private const val MAX_STRETCH = 64
