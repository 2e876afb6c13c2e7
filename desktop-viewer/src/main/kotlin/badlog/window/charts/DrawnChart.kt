package badlog.window.charts

import badlog.window.export.figure.FigureFormat

/**
 * A drawn chart of the folder's logs. It holds bytes rather than a chart of the library for charts, so that nothing of that library is
 * loaded until the first chart is drawn.
 *
 * @property name its name in names of files.
 * @property title its title.
 * @property question the question that it answers.
 * @property reading how to read it.
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
