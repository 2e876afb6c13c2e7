package badlog.window.charts

import badlog.window.export.figure.FigureFormat

/**
 * A drawn chart of the folder's logs. It holds bytes rather than an object of the chart library, so that this library is loaded only when
 * the first chart is drawn.
 *
 * @property name its name in the names of files.
 * @property title its title.
 * @property question the question that it answers.
 * @property reading an explanation of how to read it.
 */
internal class DrawnChart(
    val name: String,
    val title: String,
    val question: String,
    val reading: String,
    private val svg: String,
    private val png: ByteArray,
) {
    /** Returns the content of its file in [format]. */
    fun bytes(format: FigureFormat): ByteArray = when (format) {
        FigureFormat.SVG -> svg.encodeToByteArray()
        FigureFormat.PNG -> png
    }
}
