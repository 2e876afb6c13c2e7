package badlog.assistant.picture

import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.pen.BASELINE
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.PenImage
import badlog.viewer.draw.pen.Points
import badlog.viewer.draw.pen.TextSide
import java.awt.BasicStroke
import java.awt.Color
import java.awt.Font
import java.awt.Graphics2D
import java.awt.RenderingHints
import java.awt.Shape
import java.awt.geom.Ellipse2D
import java.awt.geom.Path2D
import java.awt.geom.Rectangle2D

/** Draws with Java's own graphics: an assistant accepts PNG only, and Skia would be 14 MB more to load. */
internal class AwtPen(private val graphics: Graphics2D) : Pen {
    override val density: Double get() = 1.0

    init {
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON)
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE)
    }

    override fun lines(strokes: Strokes, color: Int, width: Double, dash: Double) = stroke(color, width, dash) {
        for (i in 0 until strokes.count) steps(strokes.points, strokes.startOf(i), strokes.endOf(i))
    }

    override fun areas(strokes: Strokes, baseline: Double, color: Int) = fill(color) {
        for (i in 0 until strokes.count) {
            val start = strokes.startOf(i)
            val end = strokes.endOf(i)
            if (!steps(strokes.points, start, end)) continue
            lineTo(strokes.points[end - 2], baseline)
            lineTo(strokes.points[start], baseline)
            closePath()
        }
    }

    override fun segments(ends: Points, color: Int, width: Double, dash: Double) = stroke(color, width, dash) {
        for (at in 0 until ends.size step PER_LINE) steps(ends.values, at, at + PER_LINE)
    }

    override fun chain(places: Points, isClosed: Boolean, color: Int, width: Double) = stroke(color, width, dash = 0.0) {
        if (steps(places.values, 0, places.size) && isClosed) closePath()
    }

    override fun shapes(places: Points, corners: Int, color: Int) = fill(color) {
        for (at in 0 until places.size step 2 * corners) if (steps(places.values, at, at + 2 * corners)) closePath()
    }

    override fun dots(places: Points, radius: Double, color: Int) = fill(color) {
        for (at in 0 until places.size step 2) append(circle(places.values[at], places.values[at + 1], radius), false)
    }

    override fun ring(x: Double, y: Double, radius: Double, color: Int, width: Double) =
        stroke(color, width, dash = 0.0) { append(circle(x, y, radius), false) }

    override fun rectangle(left: Double, top: Double, width: Double, height: Double, color: Int) =
        fill(color) { append(Rectangle2D.Double(left, top, width, height), false) }

    override fun text(text: String, x: Double, middle: Double, letters: Double, color: Int, side: TextSide, isBold: Boolean, halo: Int?) {
        val left = when (side) {
            TextSide.LEFT -> x - widthOf(text, letters, isBold)
            TextSide.CENTER -> x - widthOf(text, letters, isBold) / 2
            TextSide.RIGHT -> x
        }
        val baseline = middle + BASELINE * letters
        if (halo != null) {
            val outline = fontOf(
                letters,
                isBold,
            ).createGlyphVector(graphics.fontRenderContext, text).getOutline(left.toFloat(), baseline.toFloat())
            stroke(halo, HALO, dash = 0.0) { append(outline, false) }
        }
        graphics.color = Color(color, true)
        graphics.font = fontOf(letters, isBold)
        graphics.drawString(text, left.toFloat(), baseline.toFloat())
    }

    override fun widthOf(text: String, letters: Double, isBold: Boolean): Double =
        fontOf(letters, isBold).getStringBounds(text, graphics.fontRenderContext).width

    override fun image(image: PenImage, left: Double, top: Double, width: Double, height: Double, opacity: Double): Unit =
        throw UnsupportedOperationException("An assistant's pictures have no field.")

    override fun clip(left: Double, top: Double, width: Double, height: Double, draw: () -> Unit) {
        val before = graphics.clip
        graphics.clip(Rectangle2D.Double(left, top, width, height))
        draw()
        graphics.clip = before
    }

    override fun moved(x: Double, y: Double, draw: () -> Unit) {
        graphics.translate(x, y)
        draw()
        graphics.translate(-x, -y)
    }

    private fun fill(color: Int, path: Path2D.() -> Unit) {
        graphics.color = Color(color, true)
        graphics.fill(Path2D.Double().apply(path))
    }

    private fun stroke(color: Int, width: Double, dash: Double, path: Path2D.() -> Unit) {
        val dashes = if (dash > 0) floatArrayOf(dash.toFloat()) else null
        val wide = if (width > 0) width.toFloat() else 1f
        graphics.color = Color(color, true)
        graphics.stroke = BasicStroke(wide, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, MITER, dashes, 0f)
        graphics.draw(Path2D.Double().apply(path))
    }

    /** Adds the line through some of [places]; false for an isolated sample, which has none. */
    private fun Path2D.steps(places: DoubleArray, from: Int, until: Int): Boolean {
        if (until - from < PER_LINE) return false
        moveTo(places[from], places[from + 1])
        for (at in from + 2 until until step 2) lineTo(places[at], places[at + 1])
        return true
    }

    private fun circle(x: Double, y: Double, radius: Double): Shape = Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius)

    private fun fontOf(letters: Double, isBold: Boolean) =
        Font(Font.SANS_SERIF, if (isBold) Font.BOLD else Font.PLAIN, 1).deriveFont(letters.toFloat())

    private companion object {
        const val PER_LINE = 4
        const val HALO = 3.0
        const val MITER = 10f
    }
}
