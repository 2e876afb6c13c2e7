package badlog.window.export.figure

import badlog.files.writeAtomically
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.figure.Sheet
import badlog.viewer.draw.pen.SvgPen
import badlog.window.pen.SkiaPen
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Image
import org.jetbrains.skia.Surface
import java.io.IOException
import java.nio.file.Path

/** The number of pixels per point in a picture, so that it is sharp in print and on high-density screens. */
internal const val PICTURE_SCALE = 2

/** Returns the drawing of [graphs] as an SVG document. */
internal fun svgOf(figure: LogFigure, graphs: List<BoardGraph>): String = onSurface(1, 1) { ruler ->
    val pen = SvgPen(ruler::widthOf)
    val sheet = Sheet(figure.width, pen).also { figure.draw(it, graphs) }
    pen.document(figure.width.toDouble(), sheet.height, PenColors.LIGHT[Shade.SURFACE])
}

/**
 * Returns the picture of [graphs], with [scale] pixels per point.
 *
 * @throws IOException with a sentence for the user, if it would be too large.
 */
internal fun imageOf(figure: LogFigure, graphs: List<BoardGraph>, scale: Int = PICTURE_SCALE): Image {
    // The height is known only after drawing.
    val height = onSurface(1, scale) { pen -> Sheet(figure.width, pen).also { figure.draw(it, graphs) }.height }
    if (height * figure.width * scale * scale > MAX_PIXELS) {
        throw IOException("The picture would be too large; select fewer graphs, or SVG.")
    }
    val rows = (height * scale).toInt()
    return Surface.makeRasterN32Premul(figure.width * scale, rows).use { surface ->
        val pen = SkiaPen(surface.canvas, scale.toDouble())
        pen.rectangle(0.0, 0.0, surface.width.toDouble(), rows.toDouble(), PenColors.LIGHT[Shade.SURFACE])
        figure.draw(Sheet(figure.width, pen), graphs)
        surface.makeImageSnapshot()
    }
}

/**
 * Writes the drawing of [graphs] to [file].
 *
 * @throws IOException with a sentence for the user, if none of [graphs] has a line, or the picture would be too large.
 */
internal fun writeFigure(figure: LogFigure, graphs: List<BoardGraph>, format: FigureFormat, file: Path) {
    if (figure.drawable(graphs).isEmpty()) throw IOException("None of the selected graphs has a line in this log; select others.")
    val bytes = when (format) {
        FigureFormat.SVG -> svgOf(figure, graphs).encodeToByteArray()
        FigureFormat.PNG -> imageOf(figure, graphs).use { checkNotNull(it.encodeToData(EncodedImageFormat.PNG)).bytes }
    }
    writeAtomically(file) { it.write(bytes) }
}

private fun <T> onSurface(pixels: Int, scale: Int, draw: (SkiaPen) -> T): T =
    Surface.makeRasterN32Premul(pixels, pixels).use { draw(SkiaPen(it.canvas, scale.toDouble())) }

private const val MAX_PIXELS = 60_000_000
