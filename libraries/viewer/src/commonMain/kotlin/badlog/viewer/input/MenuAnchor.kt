package badlog.viewer.input

/** The edges of an element that opens a menu, in pixels of the window. */
class MenuAnchor(private val left: Float, private val top: Float, private val bottom: Float) {
    /**
     * Returns the left and top of a menu of [width] by [height] in a window of [roomX] by [roomY]. The menu is below the element if it fits
     * there, otherwise above it, otherwise as low as it fits.
     */
    fun cornerOf(width: Int, height: Int, roomX: Int, roomY: Int): Pair<Float, Float> {
        val above = top - height
        val y = if (bottom + height <= roomY || above < 0) bottom else above
        return left.coerceIn(0f, maxOf(0, roomX - width).toFloat()) to y.coerceIn(0f, maxOf(0, roomY - height).toFloat())
    }
}
