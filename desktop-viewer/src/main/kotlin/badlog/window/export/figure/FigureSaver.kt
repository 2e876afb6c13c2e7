package badlog.window.export.figure

import androidx.compose.foundation.layout.size
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.toAwtImage
import androidx.compose.ui.graphics.toComposeImageBitmap
import badlog.files.writeAtomically
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.figure.Sheet
import badlog.viewer.draw.pen.SvgPen
import badlog.window.compare.ComparedRecordings
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.files.fileNameOf
import badlog.window.files.sayNoLog
import badlog.window.findings.CurrentFindings
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.FilteredEvents
import badlog.window.log.GraphBoard
import badlog.window.log.LogNotes
import badlog.window.pen.SkiaPen
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import badlog.window.task.openAction
import kotlinx.coroutines.CoroutineScope
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Image
import org.jetbrains.skia.Surface
import java.awt.HeadlessException
import java.awt.Toolkit
import java.awt.datatransfer.Clipboard
import java.awt.datatransfer.DataFlavor
import java.awt.datatransfer.StringSelection
import java.awt.datatransfer.Transferable
import java.awt.datatransfer.UnsupportedFlavorException
import java.io.IOException
import java.nio.file.Path
import java.awt.Image as AwtImage

/** Saves and copies figures of the current recording's graphs. */
internal class FigureSaver(
    private val scope: CoroutineScope,
    private val current: CurrentRecording,
    private val compared: ComparedRecordings,
    private val view: AxisView,
    private val events: FilteredEvents,
    private val findings: CurrentFindings,
    private val notes: LogNotes,
    private val board: GraphBoard,
    private val files: FileChoice,
    private val tasks: LongTasks,
    private val notices: Notices,
) {
    /** Asks for a file, and writes the figure of [graphs] as they are on the screen. */
    fun save(graphs: List<BoardGraph>, options: FigureOptions) {
        val recording = current.recording ?: return
        val ending = ".${options.format.ending}"
        val file = askToWrite(files, notices, "Save the figure", recording.file.parent, fileNameOf(recording.label), ending) ?: return
        val figure = figureOf(options)
        tasks.run("Drawing ${file.fileName}", { writeFigure(figure, graphs, options.format, file) }) {
            notices.say("Saved $file.", openAction(file, scope, notices))
        }
    }

    /** Copies a picture of [graphs]: only of the first ones, as many as stay readable. */
    fun copyShown(graphs: List<BoardGraph>) = copy(graphs.take(MAX_COPIED))

    /** Draws [graphs] as a figure of the visible range, and copies its picture to the [clipboard]. */
    fun copy(graphs: List<BoardGraph>, clipboard: () -> Clipboard = ::systemClipboard) {
        if (current.recording == null) return sayNoLog(notices)
        if (graphs.isEmpty()) return
        val options = FigureOptions(graphHeight = if (graphs.size == 1) LONE_HEIGHT else FigureOptions().graphHeight)
        val figure = figureOf(options)
        val draw = { imageOf(figure, graphs).toComposeImageBitmap() }
        tasks.run("Copying the picture", { copyImage(draw(), clipboard) }) {
            val what = graphs.singleOrNull()?.let { "“${board.titleOf(it)}”" } ?: "${graphs.size} graphs"
            notices.say("Copied a picture of $what; paste it where you like.")
        }
    }

    private fun figureOf(options: FigureOptions) = LogFigure(
        compared.drawn,
        view.viewport.visible,
        options.width,
        options.graphHeight,
        events.matching,
        findings.state.list?.timeline,
        notes.all.map { it.x },
        board.state.graphs,
        // The pointer's place is accidental, and does not belong in a figure.
        view.cursors.withoutPointer,
    )
}

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

/**
 * Copies [bitmap] to the system's [clipboard].
 *
 * @throws IOException with a sentence for the user, if the clipboard is missing, or another program is using it.
 */
internal fun copyImage(bitmap: ImageBitmap, clipboard: () -> Clipboard = ::systemClipboard) = copyImage(bitmap.toAwtImage(), clipboard)

/** Returns the clipboard that all programs of this computer share. */
internal fun systemClipboard() = Toolkit.getDefaultToolkit().systemClipboard

/**
 * Copies [text] to the system's clipboard.
 *
 * @throws IOException if there is no clipboard, or another program is using it.
 */
internal fun copyText(text: String) = copy(StringSelection(text), ::systemClipboard)

/** Copies [image] to the [clipboard], like the other function. */
internal fun copyImage(image: AwtImage, clipboard: () -> Clipboard) = copy(Picture(image), clipboard)

private fun copy(content: Transferable, clipboard: () -> Clipboard) {
    try {
        clipboard().setContents(content, null)
    } catch (e: HeadlessException) {
        throw IOException("There is no clipboard here; save a file instead.", e)
    } catch (e: IllegalStateException) {
        throw IOException("Another program is using the clipboard; try again.", e)
    }
}

private class Picture(private val image: AwtImage) : Transferable {
    override fun getTransferDataFlavors(): Array<DataFlavor> = arrayOf(DataFlavor.imageFlavor)

    override fun isDataFlavorSupported(flavor: DataFlavor): Boolean = flavor == DataFlavor.imageFlavor

    override fun getTransferData(flavor: DataFlavor): Any =
        if (isDataFlavorSupported(flavor)) image else throw UnsupportedFlavorException(flavor)
}

private const val LONE_HEIGHT = 320

/** The maximum number of graphs in a readable picture. */
private const val MAX_COPIED = 8
