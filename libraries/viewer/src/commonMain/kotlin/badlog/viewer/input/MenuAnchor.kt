package badlog.viewer.input

/** The edges of the element in the window that opens a menu, in pixels. */
class MenuAnchor(private val left: Float, private val top: Float, private val bottom: Float) {
    /**
     * Returns left and top of a menu of [width] and [height] in a window of [roomX] and [roomY]. It is below the element, or otherwise
     * above it, or otherwise as low as it fits.
     */
    fun cornerOf(width: Int, height: Int, roomX: Int, roomY: Int): Pair<Float, Float> {
        val above = top - height
        val y = if (bottom + height <= roomY || above < 0) bottom else above
        return left.coerceIn(0f, maxOf(0, roomX - width).toFloat()) to y.coerceIn(0f, maxOf(0, roomY - height).toFloat())
    }
}
