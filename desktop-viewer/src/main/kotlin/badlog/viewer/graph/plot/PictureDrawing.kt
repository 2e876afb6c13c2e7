package badlog.viewer.graph.plot

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.drawIntoCanvas
import androidx.compose.ui.graphics.drawscope.withTransform
import androidx.compose.ui.graphics.skiaCanvas
import androidx.compose.ui.graphics.toArgb
import badlog.plot.Span
import badlog.viewer.theme.Palette
import org.jetbrains.skia.Canvas
import org.jetbrains.skia.Paint
import org.jetbrains.skia.PaintMode
import org.jetbrains.skia.PaintStrokeCap
import org.jetbrains.skia.PathBuilder

/**
 * Draws the lines of [picture] where [visible] is seen now. A picture that was made for another part of x is stretched to its
 * place: it stands in until the one that is asked for is there.
 */
internal fun DrawScope.drawLines(picture: PlotPicture, visible: Span, palette: Palette) {
    val made = picture.request
    val stretch = (made.visible.width / visible.width).toFloat()
    val shift = ((made.visible.from - visible.from) / visible.width * size.width).toFloat()
    withTransform({
        clipRect(0f, 0f, size.width, picture.plotHeight)
        translate(shift, 0f)
        scale(stretch * size.width / made.width, 1f, Offset.Zero)
    }) {
        drawIntoCanvas { canvas ->
            for (line in picture.lines) drawLine(canvas.skiaCanvas, line, picture, palette.line(line.line.colour))
        }
    }
}

private fun drawLine(canvas: Canvas, line: LinePicture, picture: PlotPicture, colour: Color) {
    val density = picture.request.density
    if (picture.request.spec.isFilled) fill(canvas, line, picture, colour)
    Paint().use { paint ->
        paint.color = colour.toArgb()
        paint.isAntiAlias = true
        paint.mode = PaintMode.STROKE
        // A hairline is many times as fast as any other stroke.
        paint.strokeWidth = if (line.isDense) 0f else LINE_WIDTH * density
        for (part in line.points) if (part.size > 2) canvas.drawPolygon(part, paint)
        paint.strokeCap = PaintStrokeCap.ROUND
        paint.strokeWidth = (if (line.hasDots) DOT_WIDTH else LINE_WIDTH) * density
        // What stands alone between gaps has no line to be seen by.
        for (part in line.points) if (line.hasDots || part.size == 2) canvas.drawPoints(part, paint)
    }
}

private fun fill(canvas: Canvas, line: LinePicture, picture: PlotPicture, colour: Color) {
    val base = picture.axes[line.axis].pixelOf(0.0, picture.plotHeight).coerceIn(0f, picture.plotHeight)
    Paint().use { paint ->
        paint.color = colour.copy(alpha = FILL_OPACITY).toArgb()
        for (part in line.points) {
            val area = FloatArray(part.size + 4)
            area[0] = part[0]
            area[1] = base
            part.copyInto(area, 2)
            area[area.size - 2] = part[part.size - 2]
            area[area.size - 1] = base
            PathBuilder().use { builder -> builder.addPoly(area, true).detach().use { canvas.drawPath(it, paint) } }
        }
    }
}

private const val LINE_WIDTH = 1.5f
private const val DOT_WIDTH = 5f
private const val FILL_OPACITY = 0.19f
