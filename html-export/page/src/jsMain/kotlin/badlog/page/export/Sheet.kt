package badlog.page.export

import badlog.page.view.Palette
import badlog.viewer.draw.color.Shade
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.files.Blob
import org.w3c.files.BlobPropertyBag

/**
 * The sheet on which a figure is drawn from top to bottom, in the colors of paper.
 *
 * @property width the width in CSS pixels.
 * @property context the pen; [ratio] of its units are one CSS pixel.
 */
internal class Sheet private constructor(val width: Int, val context: CanvasRenderingContext2D, private val palette: Palette) {
    val ratio: Double = window.devicePixelRatio

    /** Where the next part begins, in CSS pixels from the top. */
    var top: Double = 0.0

    /** Where the next [text] in a line begins, in CSS pixels from the left. */
    var left: Double = MARGIN

    /** Begins a line that is [high] CSS pixels high. */
    fun line(high: Int) {
        top += high
        left = MARGIN
    }

    /** Writes [text] at the current place in the line, with a font size of [letters] CSS pixels, clipped at the edge of the sheet. */
    fun text(text: String, letters: Int, color: String = palette[Shade.MUTED], isBold: Boolean = false) {
        context.save()
        context.font = "${if (isBold) "600 " else ""}${letters * ratio}px system-ui, sans-serif"
        context.fillStyle = color
        var shown = text
        fun wide() = context.measureText(shown).width / ratio
        while (left + wide() > width - MARGIN && shown.length > 1) shown = shown.dropLast(2) + "…"
        context.fillText(shown, left * ratio, top * ratio)
        left += wide() + GAP
        context.restore()
    }

    /** Returns the width that [text] would have, in CSS pixels. */
    fun widthOf(text: String, letters: Int): Double {
        context.font = "${letters * ratio}px system-ui, sans-serif"
        return context.measureText(text).width / ratio
    }

    /** Draws a square in [color] before the next text. */
    fun swatch(color: String) {
        context.fillStyle = color
        context.fillRect(left * ratio, (top - SWATCH) * ratio, SWATCH * ratio, SWATCH * ratio)
        left += SWATCH + GAP / 2
    }

    /** Draws a part that is [high] CSS pixels high with [draw], whose origin is the current place on the sheet. */
    fun part(high: Int, draw: () -> Unit) {
        context.save()
        context.translate(0.0, top * ratio)
        draw()
        context.restore()
        top += high
    }

    internal companion object {
        /** The width of a page of paper between its margins. */
        const val PAPER = 720

        private const val MARGIN = 12.0
        private const val GAP = 8.0
        private const val SWATCH = 10.0

        /** Returns what [draw] draws as SVG. */
        fun svg(width: Int, palette: Palette, draw: Sheet.() -> Unit): String = onPaper(palette) {
            val svg = SvgContext(width * window.devicePixelRatio)
            val sheet = Sheet(width, svg.context, palette)
            sheet.draw()
            svg.document((sheet.top + GAP) * sheet.ratio, sheet.ratio)
        }

        /** Returns the same as a file. */
        fun svgFile(width: Int, palette: Palette, draw: Sheet.() -> Unit): Blob =
            Blob(arrayOf(svg(width, palette, draw)), BlobPropertyBag("image/svg+xml"))

        /** Draws the same as PNG, in the resolution of the screen, and passes it to [onReady]. */
        fun png(width: Int, palette: Palette, draw: Sheet.() -> Unit, onReady: (Blob) -> Unit) = onPaper(palette) {
            // Its height is known only after drawing.
            val trial = Sheet(width, SvgContext(width * window.devicePixelRatio).context, palette).apply(draw)
            val canvas = document.createElement("canvas").unsafeCast<HTMLCanvasElement>()
            canvas.width = (width * trial.ratio).toInt()
            canvas.height = ((trial.top + GAP) * trial.ratio).toInt()
            val context = canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
            Sheet(width, context, palette).draw()
            // The background comes last, because lanes clear what is below them.
            context.asDynamic().globalCompositeOperation = "destination-over"
            context.fillStyle = palette[Shade.SURFACE]
            context.fillRect(0.0, 0.0, canvas.width.toDouble(), canvas.height.toDouble())
            canvas.toBlob({ blob: Blob? -> if (blob != null) onReady(blob) })
        }

        private fun <T> onPaper(palette: Palette, draw: () -> T): T {
            val before = palette.isDark
            palette.isDark = false
            return try {
                draw()
            } finally {
                palette.isDark = before
            }
        }
    }
}
