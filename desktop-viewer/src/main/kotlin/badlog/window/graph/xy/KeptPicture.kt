package badlog.window.graph.xy

import androidx.compose.ui.draw.CacheDrawScope
import androidx.compose.ui.graphics.BlendMode
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.graphics.drawscope.DrawScope

/**
 * The cached pixels of a drawing: a cursor moving above it does not redraw its strokes. The next drawing of the same size reuses the
 * memory.
 */
internal class KeptPicture {
    private val scope = CanvasDrawScope()
    private var bitmap: ImageBitmap? = null

    /** Returns the picture that [draw] draws, in the size of [cache]; null if that has no pixels. */
    fun of(cache: CacheDrawScope, draw: DrawScope.() -> Unit): ImageBitmap? {
        val width = cache.size.width.toInt()
        val height = cache.size.height.toInt()
        if (width < 1 || height < 1) return null
        val pixels = bitmap?.takeIf { it.width == width && it.height == height } ?: ImageBitmap(width, height)
        bitmap = pixels
        scope.draw(cache, cache.layoutDirection, Canvas(pixels), cache.size) {
            drawRect(Color.Transparent, blendMode = BlendMode.Clear)
            draw()
        }
        return pixels
    }
}
