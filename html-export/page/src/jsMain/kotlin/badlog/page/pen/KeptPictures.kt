package badlog.page.pen

import kotlinx.browser.document
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import kotlin.math.ceil

/** A picture shared by many graphs, cached for each of their few widths until a different picture is needed. */
internal class KeptPictures {
    private val kept = ArrayList<KeptPicture>()

    /**
     * Copies the bottom of the picture of [subject] to [target]: [width] by [height] of its pixels, at [left] and [top]. If necessary,
     * [draw] draws the picture first; its last parameter is the height.
     */
    fun putOn(
        target: CanvasRenderingContext2D,
        left: Double,
        top: Double,
        width: Double,
        height: Double,
        subject: List<Any?>,
        draw: (CanvasPen, Double) -> Unit,
    ) {
        if (!(width >= 1 && height >= 1)) return
        val picture = kept.find { it.width == width } ?: KeptPicture(width).also {
            if (kept.size == MAX_KEPT) kept.removeAt(0)
            kept += it
        }
        picture.show(height, subject, draw)
        target.drawImage(picture.canvas, 0.0, picture.height - height, width, height, left, top, width, height)
    }
}

private class KeptPicture(val width: Double) {
    val canvas = document.createElement("canvas").unsafeCast<HTMLCanvasElement>()
    private val context = canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
    private var shown = emptyList<Any?>()

    /** The height of the canvas in pixels. It only grows, because resizing takes longer than drawing everything. */
    var height = 0.0
        private set

    /** Draws the picture of [wanted] unless it is already there, at least [wantedHeight] pixels high. */
    fun show(wantedHeight: Double, wanted: List<Any?>, draw: (CanvasPen, Double) -> Unit) {
        if (wantedHeight <= height && wanted == shown) return
        shown = wanted
        if (wantedHeight > height) {
            height = wantedHeight
            canvas.width = ceil(width).toInt()
            canvas.height = ceil(height).toInt()
        } else {
            context.clearRect(0.0, 0.0, width, height)
        }
        draw(CanvasPen(context), height)
    }
}

/** The maximum number of widths: one each for the graphs of the board, the graphs of the folders, and the overview. */
private const val MAX_KEPT = 3
