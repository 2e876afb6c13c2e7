package badlog.window.pen

import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.skiaCanvas
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.pen.BASELINE
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.PenImage
import badlog.viewer.draw.pen.Points
import badlog.viewer.draw.pen.TextSide
import org.jetbrains.skia.Canvas
import org.jetbrains.skia.Font
import org.jetbrains.skia.FontMgr
import org.jetbrains.skia.FontStyle
import org.jetbrains.skia.Image
import org.jetbrains.skia.Paint
import org.jetbrains.skia.PaintMode
import org.jetbrains.skia.PaintStrokeCap
import org.jetbrains.skia.PaintStrokeJoin
import org.jetbrains.skia.PathBuilder
import org.jetbrains.skia.PathEffect
import org.jetbrains.skia.Rect
import org.jetbrains.skia.SamplingMode
import org.jetbrains.skia.TextLine

/** A pen that draws on [canvas], on any thread. */
internal class SkiaPen(private val canvas: Canvas, override val density: Double) : Pen {
    override fun lines(strokes: Strokes, color: Int, width: Double, dash: Double) = stroke(color, width, dash) { paint ->
        for (i in 0 until strokes.count) {
            val start = strokes.startOf(i)
            val end = strokes.endOf(i)
            // An isolated sample has no line. A polygon is faster than a path, but its dashes restart at each edge.
            if (end - start < PER_LINE) continue
            val points = floats(strokes.points, start, end)
            if (dash > 0) shape(points, paint, isClosed = false) else canvas.drawPolygon(points, paint)
        }
    }

    override fun areas(strokes: Strokes, baseline: Double, color: Int) = fill(color) { paint ->
        for (i in 0 until strokes.count) {
            val start = strokes.startOf(i)
            val end = strokes.endOf(i)
            if (end - start < PER_LINE) continue
            val area = floats(strokes.points, start, end, extra = PER_LINE)
            area[area.size - 4] = area[area.size - 6]
            area[area.size - 3] = baseline.toFloat()
            area[area.size - 2] = area[0]
            area[area.size - 1] = baseline.toFloat()
            shape(area, paint)
        }
    }

    override fun segments(ends: Points, color: Int, width: Double, dash: Double) = stroke(color, width, dash) { paint ->
        canvas.drawLines(floats(ends.values, 0, ends.size), paint)
    }

    override fun chain(places: Points, isClosed: Boolean, color: Int, width: Double) = stroke(color, width, dash = 0.0) { paint ->
        shape(floats(places.values, 0, places.size), paint, isClosed)
    }

    override fun shapes(places: Points, corners: Int, color: Int) = fill(color) { paint ->
        for (at in 0 until places.size step 2 * corners) shape(floats(places.values, at, at + 2 * corners), paint)
    }

    override fun dots(places: Points, radius: Double, color: Int) = stroke(color, 2 * radius, dash = 0.0) { paint ->
        paint.strokeCap = PaintStrokeCap.ROUND
        if (places.size > 0) canvas.drawPoints(floats(places.values, 0, places.size), paint)
    }

    override fun ring(x: Double, y: Double, radius: Double, color: Int, width: Double) = stroke(color, width, dash = 0.0) { paint ->
        canvas.drawCircle(x.toFloat(), y.toFloat(), radius.toFloat(), paint)
    }

    override fun rectangle(left: Double, top: Double, width: Double, height: Double, color: Int) = fill(color) { paint ->
        canvas.drawRect(boxOf(left, top, width, height), paint)
    }

    override fun text(text: String, x: Double, middle: Double, letters: Double, color: Int, side: TextSide, isBold: Boolean, halo: Int?) {
        written(text, letters, isBold) { textWidth, write ->
            val left = when (side) {
                TextSide.LEFT -> x - textWidth
                TextSide.CENTER -> x - textWidth / 2
                TextSide.RIGHT -> x
            }
            val baseline = (middle + BASELINE * letters).toFloat()
            if (halo != null) stroke(halo, HALO * density, dash = 0.0) { write(left.toFloat(), baseline, it) }
            fill(color) { write(left.toFloat(), baseline, it) }
        }
    }

    override fun widthOf(text: String, letters: Double, isBold: Boolean): Double = written(text, letters, isBold) { width, _ -> width }

    override fun image(image: PenImage, left: Double, top: Double, width: Double, height: Double, opacity: Double) {
        val pixels = (image as SkiaImage).pixels
        val whole = Rect.makeWH(pixels.width.toFloat(), pixels.height.toFloat())
        Paint().use { paint ->
            paint.setAlphaf(opacity.toFloat())
            canvas.drawImageRect(pixels, whole, boxOf(left, top, width, height), SamplingMode.LINEAR, paint, true)
        }
    }

    override fun clip(left: Double, top: Double, width: Double, height: Double, draw: () -> Unit) {
        canvas.save()
        canvas.clipRect(boxOf(left, top, width, height))
        draw()
        canvas.restore()
    }

    override fun moved(x: Double, y: Double, draw: () -> Unit) {
        canvas.save()
        canvas.translate(x.toFloat(), y.toFloat())
        draw()
        canvas.restore()
    }

    private fun shape(corners: FloatArray, paint: Paint, isClosed: Boolean = true) = PathBuilder().use { builder ->
        builder.addPoly(corners, isClosed).detach().use { canvas.drawPath(it, paint) }
    }

    private inline fun fill(color: Int, draw: (Paint) -> Unit) = Paint().use { paint ->
        paint.color = color
        paint.isAntiAlias = true
        draw(paint)
    }

    private inline fun stroke(color: Int, width: Double, dash: Double, draw: (Paint) -> Unit) = fill(color) { paint ->
        paint.mode = PaintMode.STROKE
        // A hairline is many times faster than any other stroke.
        paint.strokeWidth = width.toFloat()
        paint.strokeJoin = PaintStrokeJoin.ROUND
        val dashes = if (dash > 0) PathEffect.makeDash(floatArrayOf(dash.toFloat(), dash.toFloat()), 0f) else null
        paint.pathEffect = dashes
        draw(paint)
        dashes?.close()
    }

    /** Calls [use] with the width of [text], and with a function that draws it from x on a baseline. */
    private fun <R> written(
        text: String,
        letters: Double,
        isBold: Boolean,
        use: (width: Double, write: (Float, Float, Paint) -> Unit) -> R,
    ): R = Font(if (isBold) bold else normal, letters.toFloat()).use { font ->
        if (isPlain(text) && font.getStringGlyphs(text).none { it == MISSING }) {
            use(font.measureTextWidth(text).toDouble()) { x, y, paint -> canvas.drawString(text, x, y, font, paint) }
        } else {
            TextLine.make(text, font).use { line ->
                use(line.width.toDouble()) { x, y, paint -> canvas.drawTextLine(line, x, y, paint) }
            }
        }
    }

    /**
     * Returns whether each letter of [text] is one glyph beside the previous one, as in numbers, units and most names. Everything else must
     * be shaped, which takes milliseconds for each text: all numbers on the axes of ten graphs took 100 ms.
     */
    private fun isPlain(text: String) = text.all { it < COMBINING || it in GREEK || it in PUNCTUATION }

    private fun floats(values: DoubleArray, from: Int, until: Int, extra: Int = 0): FloatArray {
        val floats = FloatArray(until - from + extra)
        for (i in from until until) floats[i - from] = values[i].toFloat()
        return floats
    }

    private fun boxOf(left: Double, top: Double, width: Double, height: Double) =
        Rect.makeXYWH(left.toFloat(), top.toFloat(), maxOf(0f, width.toFloat()), maxOf(0f, height.toFloat()))

    private companion object {
        const val PER_LINE = 4
        const val HALO = 3.0

        /** The id of the glyph for a letter that a font lacks. */
        const val MISSING: Short = 0
        const val COMBINING = '\u0300'
        val GREEK = '\u0370'..'\u03ff'
        val PUNCTUATION = '\u2010'..'\u2044'
        val normal = FontMgr.default.matchFamilyStyle("sans-serif", FontStyle.NORMAL)
        val bold = FontMgr.default.matchFamilyStyle("sans-serif", FontStyle.BOLD)
    }
}

/** A picture of [pixels], which come from the data URL [source]. */
internal class SkiaImage(val pixels: Image, source: String) : PenImage(source, pixels.width, pixels.height)

/** Returns a pen that draws on this scope. */
internal fun DrawScope.pen(): Pen = SkiaPen(drawContext.canvas.skiaCanvas, density.toDouble())
