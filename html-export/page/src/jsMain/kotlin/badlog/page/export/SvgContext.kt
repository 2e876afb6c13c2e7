package badlog.page.export

import badlog.page.dom.json
import kotlinx.browser.document
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import kotlin.math.round

/**
 * Writes what is drawn with [context] as SVG. [context] is a pen like that of a canvas, with what the graphs of a page use: paths,
 * rectangles, text, translation, and clipping by a rectangle. So the same functions draw on the screen and for a file.
 *
 * @param width the width of the drawing, in the units of the pen.
 */
internal class SvgContext(private val width: Double) {
    private val body = StringBuilder()
    private var path = StringBuilder()
    private val saved = ArrayList<dynamic>()
    private val ruler = document.createElement(
        "canvas",
    ).unsafeCast<HTMLCanvasElement>().getContext("2d").unsafeCast<CanvasRenderingContext2D>()

    private val pen: dynamic = json(
        "isSvg" to true,
        "canvas" to json("width" to width),
        "left" to 0.0,
        "top" to 0.0,
        "globalAlpha" to 1.0,
        "dash" to "",
        "clipping" to "",
        "textAlign" to "",
        "textBaseline" to "",
        "save" to { saved.add(Object.assign(json(), pen())) },
        "restore" to { Object.assign(pen(), saved.removeLast()) },
        "translate" to { x: Double, y: Double ->
            pen().left += x
            pen().top += y
        },
        "beginPath" to { path = StringBuilder() },
        "moveTo" to { x: Double, y: Double -> add("M", x, y) },
        "lineTo" to { x: Double, y: Double -> add(if (path.isEmpty()) "M" else "L", x, y) },
        "closePath" to { path.append("z") },
        "rect" to ::addRect,
        // A page only has full circles.
        "arc" to { x: Double, y: Double, radius: Double ->
            add("M", x + radius, y)
            for (way in listOf(-2, 2)) path.append("a${number(radius)} ${number(radius)} 0 1 0 ${number(way * radius)} 0")
        },
        "fill" to { write("fill") },
        "stroke" to { write("stroke") },
        "clip" to {
            body.append("<clipPath id=\"cut${++clips}\"><path d=\"$path\"/></clipPath>")
            pen().clipping = " clip-path=\"url(#cut$clips)\""
        },
        "fillRect" to { x: Double, y: Double, w: Double, h: Double ->
            path = StringBuilder()
            addRect(x, y, w, h)
            write("fill")
        },
        // A cleared area is covered again by something translucent, so it gets the background color.
        "clearRect" to { x: Double, y: Double, w: Double, h: Double ->
            path = StringBuilder()
            addRect(x, y, w, h)
            body.append("<path fill=\"#ffffff\" d=\"$path\"${pen().clipping}/>")
        },
        "setLineDash" to { lengths: Array<Double> -> pen().dash = lengths.joinToString(" ", transform = ::number) },
        "measureText" to { text: String ->
            ruler.font = pen().font
            ruler.measureText(text)
        },
        "fillText" to { text: String, x: Double, y: Double -> writeText("fill", text, x, y) },
        "strokeText" to { text: String, x: Double, y: Double -> writeText("stroke", text, x, y) },
    )

    /** The pen. */
    val context: CanvasRenderingContext2D get() = pen.unsafeCast<CanvasRenderingContext2D>()

    /** Returns the drawing as a document with the visible [height]; a CSS pixel is [ratio] of its units. */
    fun document(height: Double, ratio: Double): String =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"${number(width / ratio)}\" height=\"${number(height / ratio)}\" " +
            "viewBox=\"0 0 ${number(width)} ${number(height)}\" font-family=\"system-ui, sans-serif\">" +
            "<path fill=\"#ffffff\" d=\"M0 0H${number(width)}V${number(height)}H0z\"/>$body</svg>\n"

    // Does not exist yet while the pen is being made.
    private fun pen(): dynamic = pen

    private fun add(step: String, x: Double, y: Double) {
        path.append(step + number(pen().left + x) + " " + number(pen().top + y))
    }

    private fun addRect(x: Double, y: Double, w: Double, h: Double) {
        add("M", x, y)
        path.append("h${number(w)}v${number(h)}h${number(-w)}z")
    }

    private fun write(kind: String) {
        if (path.isNotEmpty()) body.append("<path d=\"$path\"${paint(kind)}/>")
    }

    private fun writeText(kind: String, text: String, x: Double, y: Double) {
        val font: String = pen().font
        val size = SIZE.find(font)?.value?.toDouble() ?: return
        val down = if (pen().textBaseline == "middle") {
            MIDDLE
        } else if (pen().textBaseline == "top") {
            TOP
        } else {
            0.0
        }
        val anchor = if (pen().textAlign == "right") {
            "end"
        } else if (pen().textAlign == "center") {
            "middle"
        } else {
            "start"
        }
        val weight = if (font.startsWith("6")) " font-weight=\"600\"" else ""
        val place = "x=\"${number(pen().left + x)}\" y=\"${number(pen().top + y + down * size)}\""
        body.append("<text $place font-size=\"${number(size)}\" text-anchor=\"$anchor\"$weight${paint(kind)}>${escaped(text)}</text>")
    }

    private fun paint(kind: String): String {
        val color: String = pen()[kind + "Style"]
        val opacity = pen().globalAlpha.unsafeCast<Double>() * (color.drop(SOLID).toIntOrNull(16) ?: 255) / 255
        val look = " $kind=\"${color.take(SOLID)}\"" + (if (opacity < 1) " $kind-opacity=\"${number(opacity)}\"" else "") + pen().clipping
        if (kind == "fill") return look
        val dash = if (pen().dash == "") "" else " stroke-dasharray=\"${pen().dash}\""
        return "$look fill=\"none\" stroke-linejoin=\"round\" stroke-width=\"${number(pen().lineWidth)}\"$dash"
    }

    private companion object {
        val Object: dynamic = js("Object")
        val SIZE = Regex("[\\d.]+(?=px)")
        const val MIDDLE = 0.35
        const val TOP = 0.8

        /** The length of a color that has no opacity. */
        const val SOLID = 7

        /** A page may show several drawings, and the names of their parts must differ. */
        var clips = 0
    }
}

/** Returns whether [context] writes SVG: bitmaps cannot be drawn on it. */
internal fun isSvg(context: CanvasRenderingContext2D): Boolean = context.asDynamic().isSvg == true

private fun number(value: Double) = (round(value * 100) / 100).toString()

private val NOT_XML = Regex("[\\x00-\\x1f\\ud800-\\udfff\\ufffe\\uffff]")

/** Returns [text] as XML, which allows neither control characters nor halves of surrogate pairs. */
private fun escaped(text: String) = text.replace(NOT_XML, "\uFFFD").replace("&", "&amp;").replace("<", "&lt;")
