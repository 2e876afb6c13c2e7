package badlog.window.graph.plot

import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.toArgb
import org.jetbrains.skia.Canvas
import org.jetbrains.skia.Image
import org.jetbrains.skia.Paint
import org.jetbrains.skia.PaintMode
import org.jetbrains.skia.PaintStrokeCap
import org.jetbrains.skia.PathBuilder
import org.jetbrains.skia.Surface

/**
 * Returns an image of [lines], [height] pixels high; null if there are none. Without a graphics card, long strokes are most
 * of the work of a frame, so they are drawn here, on the thread that makes the picture, and the window only copies the image.
 */
internal fun rasterOf(request: PlotRequest, axes: List<YAxis>, lines: List<LinePicture>, height: Float): Image? {
    val rows = height.toInt()
    if (lines.isEmpty() || rows < 1) return null
    return Surface.makeRasterN32Premul(request.width, rows).use { surface ->
        for (line in lines) {
            drawLine(surface.canvas, line, request, base = axes[line.axis].pixelOf(0.0, height).coerceIn(0f, height))
        }
        surface.makeImageSnapshot()
    }
}

private fun drawLine(canvas: Canvas, line: LinePicture, request: PlotRequest, base: Float) {
    val density = request.density
    val color = request.palette.line(line.line.color)
    val strokes = line.strokes
    Paint().use { paint ->
        paint.color = color.toArgb()
        paint.isAntiAlias = true
        paint.mode = PaintMode.STROKE
        // A hairline is many times faster than any other stroke.
        paint.strokeWidth = if (strokes.isDense) 0f else LINE_WIDTH * density
        for (i in 0 until strokes.count) {
            val stroke = floats(strokes.points, strokes.startOf(i), strokes.endOf(i))
            if (request.spec.isFilled) fill(canvas, stroke, base, color)
            // An isolated sample between gaps is a dot.
            if (stroke.size > 2) canvas.drawPolygon(stroke, paint)
        }
        paint.strokeCap = PaintStrokeCap.ROUND
        paint.strokeWidth = (if (strokes.isSparse) DOT_WIDTH else LINE_WIDTH) * density
        if (strokes.dotsSize > 0) canvas.drawPoints(floats(strokes.dots, 0, strokes.dotsSize), paint)
    }
}

private fun floats(values: DoubleArray, from: Int, until: Int) = FloatArray(until - from) { values[from + it].toFloat() }

private fun fill(canvas: Canvas, stroke: FloatArray, base: Float, color: Color) {
    Paint().use { paint ->
        paint.color = color.copy(alpha = FILL_OPACITY).toArgb()
        val area = FloatArray(stroke.size + 4)
        area[0] = stroke[0]
        area[1] = base
        stroke.copyInto(area, 2)
        area[area.size - 2] = stroke[stroke.size - 2]
        area[area.size - 1] = base
        PathBuilder().use { builder -> builder.addPoly(area, true).detach().use { canvas.drawPath(it, paint) } }
    }
}

private const val LINE_WIDTH = 1.5f
private const val DOT_WIDTH = 5f
private const val FILL_OPACITY = 0.19f
