package badlog.page.conformance

import badlog.page.pen.CanvasPen
import badlog.page.pen.PageImage
import badlog.viewer.draw.pen.PEN_PRIMITIVES
import badlog.viewer.draw.pen.PEN_TEXTS
import badlog.viewer.draw.pen.PRIMITIVE_HEIGHT
import badlog.viewer.draw.pen.PRIMITIVE_IMAGE
import badlog.viewer.draw.pen.PRIMITIVE_WIDTH
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.PenImage
import badlog.viewer.draw.pen.PenPicture
import badlog.viewer.draw.pen.SvgPen
import kotlinx.browser.document
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLImageElement
import kotlin.js.Promise

/** The names of the pictures that [penDifferences] can draw. */
@OptIn(ExperimentalJsExport::class)
@JsExport
public fun penPictures(): Array<String> = (PEN_PRIMITIVES.keys + PEN_TEXTS.keys).toTypedArray()

/**
 * Promises two differences for the picture [name] on a canvas of the page's pen. They are those from a blank canvas, and from the browser's
 * picture of the common pen's SVG.
 *
 * Each is the mean difference of a color component, 0 to 255. For a text, two more numbers follow, for the canvas and for the SVG: the
 * pixels by which the covered rectangle differs from the rectangle that the page's pen measures; NaN if the text covers nothing.
 */
@OptIn(ExperimentalJsExport::class)
@JsExport
public fun penDifferences(name: String): Promise<Array<Double>> = imageOf(PRIMITIVE_IMAGE).then { element ->
    val image = PageImage(element, PRIMITIVE_IMAGE)
    val draw = drawingOf(name)
    val canvas = picture { draw(CanvasPen(it), image) }
    val pen = SvgPen({ _, _, _ -> 0.0 }).also { draw(it, image) }
    val svg = pen.document(PRIMITIVE_WIDTH.toDouble(), PRIMITIVE_HEIGHT.toDouble(), WHITE)
    imageOf("data:image/svg+xml," + encodeURIComponent(svg)).then { written ->
        val file = picture { it.drawImage(written, 0.0, 0.0) }
        val box = PEN_TEXTS[name]?.boxFor(CanvasPen(newContext())::widthOf)
        val places = if (box == null) emptyList() else listOf(canvas, file).map { it.covered()?.distanceFrom(box) ?: Double.NaN }
        (listOf(canvas.differenceFrom(picture { }), canvas.differenceFrom(file)) + places).toTypedArray()
    }
}.unsafeCast<Promise<Array<Double>>>()

/** Returns the drawing of picture [name]: a primitive or a text. Its letters are the same within one browser. */
private fun drawingOf(name: String): Pen.(PenImage) -> Unit = PEN_PRIMITIVES[name] ?: { PEN_TEXTS.getValue(name).writeWith(this) }

/** Promises the image at [address] once it can be drawn. */
private fun imageOf(address: String): Promise<HTMLImageElement> {
    val image = document.createElement("img").unsafeCast<HTMLImageElement>()
    image.src = address
    return image.asDynamic().decode().unsafeCast<Promise<Unit>>().then { image }
}

/** Returns the drawing of [draw] on white. */
private fun picture(draw: (CanvasRenderingContext2D) -> Unit): PenPicture {
    val context = newContext()
    context.fillStyle = "#fff"
    context.fillRect(0.0, 0.0, PRIMITIVE_WIDTH.toDouble(), PRIMITIVE_HEIGHT.toDouble())
    draw(context)
    // Red, green, blue and opacity; the opacity is the white background's.
    val parts = context.getImageData(0.0, 0.0, PRIMITIVE_WIDTH.toDouble(), PRIMITIVE_HEIGHT.toDouble()).data.unsafeCast<ByteArray>()
    fun part(at: Int) = parts[at].toInt() and 0xFF
    return PenPicture(IntArray(PRIMITIVE_WIDTH * PRIMITIVE_HEIGHT) { (part(4 * it) shl 16) or (part(4 * it + 1) shl 8) or part(4 * it + 2) })
}

private fun newContext(): CanvasRenderingContext2D {
    val canvas = document.createElement("canvas").unsafeCast<HTMLCanvasElement>()
    canvas.width = PRIMITIVE_WIDTH
    canvas.height = PRIMITIVE_HEIGHT
    return canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
}

private external fun encodeURIComponent(text: String): String

private const val WHITE = (0xFF shl 24) or 0xFFFFFF
