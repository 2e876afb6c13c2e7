package badlog.viewer.takeaway.figure

import badlog.viewer.app.Viewer
import badlog.viewer.compare.drawnRecordings
import badlog.viewer.files.askToWrite
import badlog.viewer.files.fileNameOf
import badlog.viewer.files.writeWhole
import badlog.viewer.graph.GraphSpec
import badlog.viewer.takeaway.openAction
import java.io.IOException
import java.nio.file.Path
import javax.imageio.ImageIO

/** Asks for a file, and writes the figure of [graphs] as they are on the screen. */
internal fun saveFigure(viewer: Viewer, graphs: List<GraphSpec>, options: FigureOptions) {
    val recording = viewer.open ?: return
    val ending = ".${options.format.ending}"
    val file = askToWrite(viewer, "Save the figure", recording.file.parent, fileNameOf(recording.label), ending) ?: return
    val builder = FigureBuilder(viewer.drawnRecordings(), viewer.viewport.visible, options.width)
    viewer.tasks.run("Drawing ${file.fileName}", { writeFigure(drawable(builder.build(graphs)), options, file) }) {
        viewer.notices.say("Saved $file.", openAction(viewer, file))
    }
}

/** [figure], where there is anything in it to draw. */
internal fun drawable(figure: Figure): Figure =
    if (figure.frames.isEmpty()) throw IOException("None of the chosen graphs has a line in this log; choose others.") else figure

/** Writes [figure] to [file]. */
internal fun writeFigure(figure: Figure, options: FigureOptions, file: Path) {
    val svg = svgOf(figure, options)
    if (Thread.interrupted()) throw InterruptedException()
    when (options.format) {
        FigureFormat.SVG -> writeWhole(file) { it.write(svg.encodeToByteArray()) }

        FigureFormat.PNG -> {
            val image = imageOf(svg, options.width, PICTURE_SCALE)
            writeWhole(file) { ImageIO.write(image, "png", it) }
        }
    }
}
