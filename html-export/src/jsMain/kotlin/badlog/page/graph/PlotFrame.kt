package badlog.page.graph

/** Where x and y of a plot stand on its canvas. */
internal class PlotFrame(
    val left: Double,
    val top: Double,
    val width: Double,
    val height: Double,
    private val xFrom: Double,
    private val xTo: Double,
    private val yFrom: Double,
    private val yTo: Double,
) {
    val right: Double get() = left + width
    val bottom: Double get() = top + height

    fun pixelOfX(x: Double): Double = left + (x - xFrom) / (xTo - xFrom) * width

    fun pixelOfY(y: Double): Double = top + (yTo - y) / (yTo - yFrom) * height

    /** The pixel of 0, or of the edge nearest to it: where a filled area ends. */
    val baseline: Double get() = pixelOfY(0.0).coerceIn(top, bottom)
}
