package badlog.page.graph

import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import kotlin.math.ceil

/** A picture that many graphs show, kept until another is asked for: most graphs of a screen have the same. */
internal class KeptPicture {
    private val canvas = document.createElement("canvas").unsafeCast<HTMLCanvasElement>()
    private val picture = canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
    private var shown = emptyList<Any?>()

    /** Puts the picture of [subject] on [target]: [width] by [height] of its pixels from [left] and [top] on, which [draw] draws where need be. */
    fun putOn(
        target: CanvasRenderingContext2D,
        left: Double,
        top: Double,
        width: Double,
        height: Double,
        vararg subject: Any?,
        draw: (CanvasRenderingContext2D) -> Unit,
    ) {
        if (!(width >= 1 && height >= 1)) return
        val wanted = listOf(width, height, window.devicePixelRatio, *subject)
        if (wanted != shown) {
            shown = wanted
            // It only grows: another size takes longer than all that is drawn.
            if (width > canvas.width) canvas.width = ceil(width).toInt()
            if (height > canvas.height) canvas.height = ceil(height).toInt()
            picture.clearRect(0.0, 0.0, canvas.width.toDouble(), canvas.height.toDouble())
            draw(picture)
        }
        target.drawImage(canvas, 0.0, 0.0, width, height, left, top, width, height)
    }
}
