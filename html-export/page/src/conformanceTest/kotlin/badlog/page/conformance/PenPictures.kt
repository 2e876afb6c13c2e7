package badlog.page.conformance

import badlog.page.pen.CanvasPen
import badlog.viewer.draw.pen.PEN_PRIMITIVES
import badlog.viewer.draw.pen.PRIMITIVE_HEIGHT
import badlog.viewer.draw.pen.PRIMITIVE_WIDTH
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.SvgPen
import badlog.viewer.draw.pen.TextSide
import kotlinx.browser.document
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLImageElement
import kotlin.js.Promise
import kotlin.math.abs

/** What is drawn: besides the primitives, texts, whose letters are the same in one browser, and what the page draws once and copies. */
private val PICTURES: Map<String, Pen.() -> Unit> = PEN_PRIMITIVES + mapOf(
    "texts" to {
        text("12.5 V", 20.0, 30.0, 14.0, BLACK)
        text("left", 190.0, 30.0, 14.0, BLACK, TextSide.LEFT)
        text("bold, with a halo", 100.0, 70.0, 18.0, BLUE, TextSide.CENTER, isBold = true, halo = YELLOW)
    },
    "a layer" to {
        layer("layer", 40.0, 20.0, 100.0, 50.0, emptyList()) { pen, height -> pen.rectangle(10.0, 10.0, 50.0, height - 20.0, BLUE) }
    },
)

/** The names of the pictures that [penDifferences] can draw. */
@OptIn(ExperimentalJsExport::class)
@JsExport
public fun penPictures(): Array<String> = PICTURES.keys.toTypedArray()

/**
 * Promises how much the canvas that the page's pen draws picture [name] on differs from a blank one, and how much from the browser's picture of
 * the SVG that the common pen writes: each the mean difference of a color's part, from 0 to 255.
 */
@OptIn(ExperimentalJsExport::class)
@JsExport
public fun penDifferences(name: String): Promise<Array<Double>> {
    val draw = PICTURES.getValue(name)
    val canvas = pixels { CanvasPen(it).draw() }
    val svg = SvgPen({ _, _, _ -> 0.0 }).apply(draw).document(PRIMITIVE_WIDTH.toDouble(), PRIMITIVE_HEIGHT.toDouble(), WHITE)
    val image = document.createElement("img").unsafeCast<HTMLImageElement>()
    image.src = "data:image/svg+xml," + encodeURIComponent(svg)
    return image.asDynamic().decode().unsafeCast<Promise<Unit>>().then {
        val written = pixels { it.drawImage(image, 0.0, 0.0) }
        arrayOf(difference(canvas, pixels { }), difference(canvas, written))
    }
}

/** Returns the four parts of each pixel's color of what [draw] draws on white. */
private fun pixels(draw: (CanvasRenderingContext2D) -> Unit): ByteArray {
    val canvas = document.createElement("canvas").unsafeCast<HTMLCanvasElement>()
    canvas.width = PRIMITIVE_WIDTH
    canvas.height = PRIMITIVE_HEIGHT
    val context = canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
    context.fillStyle = "#fff"
    context.fillRect(0.0, 0.0, PRIMITIVE_WIDTH.toDouble(), PRIMITIVE_HEIGHT.toDouble())
    draw(context)
    return context.getImageData(0.0, 0.0, PRIMITIVE_WIDTH.toDouble(), PRIMITIVE_HEIGHT.toDouble()).data.unsafeCast<ByteArray>()
}

private fun difference(one: ByteArray, other: ByteArray): Double {
    // The last part, the opacity, is that of the white below.
    val sum = one.indices.sumOf { abs((one[it].toInt() and 0xFF) - (other[it].toInt() and 0xFF)) }
    return sum / (PARTS * PRIMITIVE_WIDTH * PRIMITIVE_HEIGHT)
}

private external fun encodeURIComponent(text: String): String

private const val PARTS = 3.0
private const val BLACK = 0xFF shl 24
private const val BLUE = BLACK or 0x0B62C4
private const val YELLOW = BLACK or 0xFFE080
private const val WHITE = BLACK or 0xFFFFFF
