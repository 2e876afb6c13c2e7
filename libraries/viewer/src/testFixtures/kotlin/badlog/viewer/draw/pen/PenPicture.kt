package badlog.viewer.draw.pen

import kotlin.math.abs

/** The drawing of a pen on white, [PRIMITIVE_WIDTH] by [PRIMITIVE_HEIGHT]: the colors of its [pixels] as `0xRRGGBB`, row by row. */
class PenPicture(private val pixels: IntArray) {
    /** Returns the mean difference from [other] of a color's part, from 0 to 255. */
    fun differenceFrom(other: PenPicture): Double {
        var sum = 0L
        for (i in pixels.indices) for (shift in 0..16 step 8) sum += abs(part(pixels[i], shift) - part(other.pixels[i], shift))
        return sum / (3.0 * pixels.size)
    }

    /** Returns the smallest rectangle around all pixels that are not white; null if all are white. */
    fun covered(): PenBox? {
        val drawn = pixels.indices.filter { i -> (0..16 step 8).any { part(pixels[i], it) < WHITE_PART } }
        if (drawn.isEmpty()) return null
        val columns = drawn.map { it % PRIMITIVE_WIDTH }
        val rows = drawn.map { it / PRIMITIVE_WIDTH }
        return PenBox(columns.min().toDouble(), rows.min().toDouble(), columns.max() + 1.0, rows.max() + 1.0)
    }

    /** Returns the number of pixels with red, green and blue of at most [most]. */
    fun dark(most: Int): Int = pixels.count { pixel -> (0..16 step 8).all { part(pixel, it) <= most } }

    private fun part(color: Int, shift: Int) = (color shr shift) and 0xFF
}

/** A part of a picture. */
data class PenBox(val left: Double, val top: Double, val right: Double, val bottom: Double) {
    /** Returns the largest distance of an edge from the same edge of [other], in pixels. */
    fun distanceFrom(other: PenBox): Double {
        val distances = listOf(left - other.left, top - other.top, right - other.right, bottom - other.bottom)
        return distances.maxOf { abs(it) }
    }
}

/** A smoothed edge may be a shade of white that is invisible. */
private const val WHITE_PART = 224
