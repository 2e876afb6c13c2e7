package badlog.viewer.draw.pen

import badlog.viewer.draw.curve.Strokes
import kotlin.math.abs
import kotlin.math.roundToLong

/**
 * Writes a drawing as SVG, in CSS pixels.
 *
 * @param ruler returns the width of a text from its font size and whether it is bold: SVG has no font before it is displayed.
 * @param prefix the start of the names of the drawing's parts; must differ from other drawings in the same document.
 * @param cssOf returns a color's notation for style sheets, from its red, green and blue only. A drawing inside a page can name the page's
 *   colors, which follow its theme.
 */
class SvgPen(
    private val ruler: (String, Double, Boolean) -> Double,
    private val prefix: String = "cut",
    private val cssOf: (Int) -> String = ::rgbOf,
) : Pen {
    override val density: Double get() = 1.0

    private val body = StringBuilder()
    private var left = 0.0
    private var top = 0.0
    private var clip: Clip? = null
    private var clips = 0

    /** Returns the drawing as a document of [width] by [height], on a [background]. */
    fun document(width: Double, height: Double, background: Int): String {
        val paper = "<path fill=\"${cssOf(background)}\" d=\"M0 0H${numberOf(width)}V${numberOf(height)}H0z\"/>"
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"${numberOf(width)}\" height=\"${numberOf(height)}\" " +
            "viewBox=\"0 0 ${numberOf(width)} ${numberOf(height)}\" font-family=\"system-ui, sans-serif\">$paper$body</svg>\n"
    }

    /** Draws [draw], with [title] as the tooltip. */
    fun titled(title: String, draw: () -> Unit) {
        body.append("<g><title>${xmlOf(title)}</title>")
        draw()
        body.append("</g>")
    }

    override fun lines(strokes: Strokes, color: Int, width: Double, dash: Double) = stroke(color, width, dash) {
        for (i in 0 until strokes.count) steps(strokes.points, strokes.startOf(i), strokes.endOf(i))
    }

    override fun areas(strokes: Strokes, baseline: Double, color: Int) = fill(color) {
        for (i in 0 until strokes.count) {
            val start = strokes.startOf(i)
            val end = strokes.endOf(i)
            if (!steps(strokes.points, start, end)) continue
            step('L', strokes.points[end - 2], baseline)
            step('L', strokes.points[start], baseline)
            body.append('z')
        }
    }

    override fun segments(ends: Points, color: Int, width: Double, dash: Double) = stroke(color, width, dash) {
        for (at in 0 until ends.size step PER_LINE) steps(ends.values, at, at + PER_LINE)
    }

    override fun chain(places: Points, isClosed: Boolean, color: Int, width: Double) = stroke(color, width, 0.0) {
        if (steps(places.values, 0, places.size) && isClosed) body.append('z')
    }

    override fun shapes(places: Points, corners: Int, color: Int) = fill(color) {
        for (at in 0 until places.size step 2 * corners) {
            if (steps(places.values, at, at + 2 * corners)) body.append('z')
        }
    }

    override fun dots(places: Points, radius: Double, color: Int) = fill(color) {
        for (at in 0 until places.size step 2) circle(places.values[at], places.values[at + 1], radius)
    }

    override fun ring(x: Double, y: Double, radius: Double, color: Int, width: Double) = stroke(color, width, 0.0) { circle(x, y, radius) }

    override fun rectangle(left: Double, top: Double, width: Double, height: Double, color: Int) = fill(color) {
        box(left, top, width, height)
    }

    override fun text(text: String, x: Double, middle: Double, letters: Double, color: Int, side: TextSide, isBold: Boolean, halo: Int?) {
        val anchor = when (side) {
            TextSide.LEFT -> " text-anchor=\"end\""
            TextSide.CENTER -> " text-anchor=\"middle\""
            TextSide.RIGHT -> ""
        }
        val place = "<text x=\"${numberOf(left + x)}\" y=\"${numberOf(top + middle + BASELINE * letters)}\" " +
            "font-size=\"${numberOf(letters)}\"$anchor${if (isBold) " font-weight=\"bold\"" else ""}"
        val written = "$clipping>${xmlOf(text)}</text>"
        // The outline is a text of its own below the letters: only browsers know the property for it.
        if (halo != null) {
            body.append("$place aria-hidden=\"true\" fill=\"none\" stroke=\"${cssOf(halo)}\" stroke-width=\"3\" stroke-linejoin=\"round\"")
            body.append(written)
        }
        body.append(place).append(paint("fill", color)).append(written)
    }

    override fun widthOf(text: String, letters: Double, isBold: Boolean): Double = ruler(text, letters, isBold)

    override fun image(image: PenImage, left: Double, top: Double, width: Double, height: Double, opacity: Double) {
        body.append("<image x=\"${numberOf(this.left + left)}\" y=\"${numberOf(this.top + top)}\" ")
        body.append("width=\"${numberOf(width)}\" height=\"${numberOf(height)}\" preserveAspectRatio=\"none\" ")
        // Only browsers know the attribute without a namespace.
        body.append("opacity=\"${numberOf(opacity)}\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" ")
        body.append("xlink:href=\"${xmlOf(image.source)}\"$clipping/>")
    }

    override fun clip(left: Double, top: Double, width: Double, height: Double, draw: () -> Unit) {
        val outer = clip
        val inner = Clip(this.left + left, this.top + top, this.left + left + width, this.top + top + height, "$prefix${++clips}")
        val both = if (outer == null) inner else inner.within(outer)
        body.append("<clipPath id=\"${both.name}\"><path d=\"")
        box(both.left - this.left, both.top - this.top, both.right - both.left, both.bottom - both.top)
        body.append("\"/></clipPath>")
        clip = both
        draw()
        clip = outer
    }

    override fun moved(x: Double, y: Double, draw: () -> Unit) {
        left += x
        top += y
        draw()
        left -= x
        top -= y
    }

    private val clipping get() = clip?.let { " clip-path=\"url(#${it.name})\"" }.orEmpty()

    private inline fun fill(color: Int, path: () -> Unit) = draw(paint("fill", color), path)

    private inline fun stroke(color: Int, width: Double, dash: Double, path: () -> Unit) {
        val dashes = if (dash > 0) " stroke-dasharray=\"${numberOf(dash)}\"" else ""
        val wide = numberOf(if (width > 0) width else 1.0)
        draw("${paint("stroke", color)} fill=\"none\" stroke-linejoin=\"round\" stroke-width=\"$wide\"$dashes", path)
    }

    private inline fun draw(look: String, path: () -> Unit) {
        val before = body.length
        body.append("<path d=\"")
        val empty = body.length
        path()
        if (body.length == empty) body.setLength(before) else body.append("\"$look$clipping/>")
    }

    private fun paint(kind: String, color: Int): String {
        val opacity = (color ushr ALPHA_BITS) / OPAQUE
        return " $kind=\"${cssOf(color)}\"" + if (opacity < 1) " $kind-opacity=\"${numberOf(opacity)}\"" else ""
    }

    /** Adds the line through some of [places]; returns false for an isolated sample, which has none. */
    private fun steps(places: DoubleArray, from: Int, until: Int): Boolean {
        if (until - from < PER_LINE) return false
        step('M', places[from], places[from + 1])
        for (at in from + 2 until until step 2) step('L', places[at], places[at + 1])
        return true
    }

    private fun step(kind: Char, x: Double, y: Double) {
        body.append(kind).append(numberOf(left + x)).append(' ').append(numberOf(top + y))
    }

    private fun box(left: Double, top: Double, width: Double, height: Double) {
        step('M', left, top)
        body.append("h${numberOf(width)}v${numberOf(height)}h${numberOf(-width)}z")
    }

    private fun circle(x: Double, y: Double, radius: Double) {
        step('M', x + radius, y)
        val half = "a${numberOf(radius)} ${numberOf(radius)} 0 1 0 "
        body.append("$half${numberOf(-2 * radius)} 0$half${numberOf(2 * radius)} 0")
    }

    /** A clipping rectangle in the document's coordinates, called [name] in the document. */
    private class Clip(val left: Double, val top: Double, val right: Double, val bottom: Double, val name: String) {
        /** Returns the part of this rectangle within [outer]; it may be empty. */
        fun within(outer: Clip): Clip {
            val fromX = maxOf(left, outer.left)
            val fromY = maxOf(top, outer.top)
            return Clip(fromX, fromY, maxOf(fromX, minOf(right, outer.right)), maxOf(fromY, minOf(bottom, outer.bottom)), name)
        }
    }
}

/** Returns [value] with at most two decimals. A hundredth of a pixel is invisible, and further digits would take most of the file. */
private fun numberOf(value: Double): String {
    val hundredths = (value * 100).roundToLong()
    val whole = abs(hundredths) / 100
    val rest = (abs(hundredths) % 100).toInt()
    val sign = if (hundredths < 0) "-" else ""
    return when {
        rest == 0 -> "$sign$whole"
        rest % 10 == 0 -> "$sign$whole.${rest / 10}"
        else -> "$sign$whole.${rest.toString().padStart(2, '0')}"
    }
}

private fun rgbOf(color: Int) = "#" + (color and 0xFFFFFF).toString(16).padStart(6, '0')

/** Returns [text] as XML, which allows neither control characters nor halves of surrogate pairs. */
private fun xmlOf(text: String) = buildString {
    text.forEachIndexed { i, letter ->
        val isHalf = when {
            letter.isHighSurrogate() -> text.getOrNull(i + 1)?.isLowSurrogate() != true
            letter.isLowSurrogate() -> text.getOrNull(i - 1)?.isHighSurrogate() != true
            else -> letter < ' ' || letter >= NO_LETTER
        }
        append(
            when {
                isHalf -> "\uFFFD"
                letter == '&' -> "&amp;"
                letter == '<' -> "&lt;"
                letter == '"' -> "&quot;"
                else -> letter.toString()
            },
        )
    }
}

private const val NO_LETTER = '\uFFFE'

private const val PER_LINE = 4
private const val ALPHA_BITS = 24
private const val OPAQUE = 255.0
