package badlog.page.pen

import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.pen.BASELINE
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.PenImage
import badlog.viewer.draw.pen.Points
import badlog.viewer.draw.pen.TextSide
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLImageElement
import kotlin.math.PI
import kotlin.math.round

/** Makes this canvas as wide as its place on the page and [height] CSS pixels high, and calls [draw] with its width in physical pixels. */
internal fun HTMLCanvasElement.paint(height: Int, draw: (Pen, width: Double) -> Unit) {
    val ratio = window.devicePixelRatio
    style.height = "${height}px"
    width = round(clientWidth * ratio).toInt()
    this.height = round(height * ratio).toInt()
    draw(CanvasPen(getContext("2d").unsafeCast<CanvasRenderingContext2D>()), width.toDouble())
}

/** A pen that draws on the canvas of [context]. All canvases of the page share its layers. */
internal class CanvasPen(private val context: CanvasRenderingContext2D) : Pen {
    override val density: Double = window.devicePixelRatio

    /** The font that [context] has; empty if unknown. */
    private var font = ""

    override fun lines(strokes: Strokes, color: Int, width: Double, dash: Double) {
        context.beginPath()
        for (i in 0 until strokes.count) steps(strokes.points, strokes.startOf(i), strokes.endOf(i))
        stroke(color, width, dash)
    }

    override fun areas(strokes: Strokes, baseline: Double, color: Int) {
        context.beginPath()
        for (i in 0 until strokes.count) {
            val start = strokes.startOf(i)
            val end = strokes.endOf(i)
            steps(strokes.points, start, end)
            context.lineTo(strokes.points[end - 2], baseline)
            context.lineTo(strokes.points[start], baseline)
            context.closePath()
        }
        fill(color)
    }

    override fun segments(ends: Points, color: Int, width: Double, dash: Double) {
        if (ends.size == 0) return
        context.beginPath()
        for (at in 0 until ends.size step 4) steps(ends.values, at, at + 4)
        stroke(color, width, dash)
    }

    override fun chain(places: Points, isClosed: Boolean, color: Int, width: Double) {
        context.beginPath()
        steps(places.values, 0, places.size)
        if (isClosed) context.closePath()
        stroke(color, width, dash = 0.0)
    }

    override fun shapes(places: Points, corners: Int, color: Int) {
        if (places.size == 0) return
        context.beginPath()
        for (at in 0 until places.size step 2 * corners) {
            steps(places.values, at, at + 2 * corners)
            context.closePath()
        }
        fill(color)
    }

    override fun dots(places: Points, radius: Double, color: Int) {
        if (places.size == 0) return
        context.beginPath()
        for (at in 0 until places.size step 2) circle(places.values[at], places.values[at + 1], radius)
        fill(color)
    }

    override fun ring(x: Double, y: Double, radius: Double, color: Int, width: Double) {
        context.beginPath()
        circle(x, y, radius)
        stroke(color, width, dash = 0.0)
    }

    override fun rectangle(left: Double, top: Double, width: Double, height: Double, color: Int) {
        context.fillStyle = cssOf(color)
        context.fillRect(left, top, width, height)
    }

    override fun text(text: String, x: Double, middle: Double, letters: Double, color: Int, side: TextSide, isBold: Boolean, halo: Int?) {
        setFont(letters, isBold)
        context.asDynamic().textAlign = ALIGNMENTS[side.ordinal]
        val baseline = middle + BASELINE * letters
        if (halo != null) {
            context.asDynamic().lineJoin = "round"
            context.strokeStyle = cssOf(halo)
            context.lineWidth = HALO * density
            context.strokeText(text, x, baseline)
        }
        context.fillStyle = cssOf(color)
        context.fillText(text, x, baseline)
    }

    override fun widthOf(text: String, letters: Double, isBold: Boolean): Double {
        setFont(letters, isBold)
        return context.measureText(text).width
    }

    override fun image(image: PenImage, left: Double, top: Double, width: Double, height: Double, opacity: Double) {
        context.globalAlpha = opacity
        context.drawImage(image.unsafeCast<PageImage>().element, left, top, width, height)
        context.globalAlpha = 1.0
    }

    override fun clip(left: Double, top: Double, width: Double, height: Double, draw: () -> Unit) {
        val before = font
        context.save()
        context.beginPath()
        context.rect(left, top, width, height)
        context.clip()
        draw()
        context.restore()
        font = before
    }

    override fun moved(x: Double, y: Double, draw: () -> Unit) {
        context.translate(x, y)
        draw()
        context.translate(-x, -y)
    }

    override fun layer(
        name: String,
        left: Double,
        top: Double,
        width: Double,
        height: Double,
        key: List<Any?>,
        draw: (Pen, Double) -> Unit,
    ) = layers.getOrPut(name, ::KeptPictures).putOn(context, left, top, width, height, key + density, draw)

    private fun steps(places: DoubleArray, from: Int, until: Int) {
        // An isolated sample has no line.
        if (until - from < 4) return
        context.moveTo(places[from], places[from + 1])
        for (at in from + 2 until until step 2) context.lineTo(places[at], places[at + 1])
    }

    private fun circle(x: Double, y: Double, radius: Double) {
        context.moveTo(x + radius, y)
        context.arc(x, y, radius, 0.0, 2 * PI)
    }

    private fun fill(color: Int) {
        context.fillStyle = cssOf(color)
        context.fill()
    }

    private fun stroke(color: Int, width: Double, dash: Double) {
        context.strokeStyle = cssOf(color)
        context.lineWidth = if (width > 0) width else 1.0
        context.asDynamic().lineJoin = "round"
        if (dash > 0) context.setLineDash(arrayOf(dash))
        context.stroke()
        if (dash > 0) context.setLineDash(emptyArray())
    }

    private fun setFont(letters: Double, isBold: Boolean) {
        val wanted = "${if (isBold) "bold " else ""}${letters}px system-ui, -apple-system, \"Segoe UI\", Roboto, sans-serif"
        // A browser recalculates the style of the page for each new font.
        if (wanted != font) context.font = wanted
        font = wanted
    }

    private companion object {
        val layers = HashMap<String, KeptPictures>()
        val ALIGNMENTS = arrayOf("right", "center", "left")
        const val HALO = 3.0
    }
}

/** A picture in an [element] that has been loaded from the data URL [source]. */
internal class PageImage(val element: HTMLImageElement, source: String) : PenImage(source, element.naturalWidth, element.naturalHeight)

private val colors = HashMap<Int, String>()

/** Returns [color], given as `0xAARRGGBB`, in the notation of style sheets. */
private fun cssOf(color: Int): String = colors.getOrPut(color) {
    fun hex(part: Int, digits: Int) = part.toString(16).padStart(digits, '0')
    val alpha = color ushr 24
    "#" + hex(color and 0xFFFFFF, 6) + if (alpha == 255) "" else hex(alpha, 2)
}
