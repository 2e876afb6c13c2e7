package badlog.page

import java.awt.image.BufferedImage
import java.io.InputStream
import javax.imageio.ImageIO
import kotlin.math.abs

/** The drawing inside a graph's frame, pixel by pixel. */
internal class FramePicture private constructor(private val image: BufferedImage) {
    val width: Int get() = image.width
    val height: Int get() = image.height

    /** Returns for each pixel column the number of its pixels with the [color]. */
    fun columnsOf(color: Int): List<Int> = List(width) { x -> (0 until height).count { y -> isLike(x, y, color) } }

    /** Returns for each pixel row, from the top, the number of its pixels with the [color]. */
    fun rowsOf(color: Int): List<Int> = List(height) { y -> (0 until width).count { x -> isLike(x, y, color) } }

    private fun isLike(x: Int, y: Int, color: Int): Boolean {
        val pixel = image.getRGB(x, y)
        if (pixel ushr 24 <= MIN_ALPHA) return false
        return (0..16 step 8).all { abs((pixel shr it and 255) - (color shr it and 255)) < NEAR }
    }

    companion object {
        // Fainter pixels are the edges of drawn shapes.
        private const val MIN_ALPHA = 60

        // The maximum difference in red, green and blue between equal colors.
        private const val NEAR = 40

        /** Returns the part of the picture [png] that begins at ([left], [top]) and has the size [width] times [height]. */
        fun of(png: InputStream, left: Int, top: Int, width: Int, height: Int): FramePicture {
            val whole = ImageIO.read(png)
            val visibleWidth = minOf(width, whole.width - left)
            return FramePicture(whole.getSubimage(left, top, visibleWidth, minOf(height, whole.height - top)))
        }
    }
}
