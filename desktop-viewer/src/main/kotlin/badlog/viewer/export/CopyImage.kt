package badlog.viewer.export

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.toAwtImage
import badlog.viewer.app.Viewer
import badlog.viewer.compare.drawnRecordings
import badlog.viewer.export.figure.FigureBuilder
import badlog.viewer.export.figure.FigureOptions
import badlog.viewer.export.figure.PICTURE_SCALE
import badlog.viewer.export.figure.drawable
import badlog.viewer.export.figure.imageOf
import badlog.viewer.export.figure.svgOf
import badlog.viewer.files.sayNoLog
import badlog.viewer.graph.GraphSpec
import java.awt.HeadlessException
import java.awt.Image
import java.awt.Toolkit
import java.awt.datatransfer.Clipboard
import java.awt.datatransfer.DataFlavor
import java.awt.datatransfer.Transferable
import java.awt.datatransfer.UnsupportedFlavorException
import java.io.IOException

/**
 * Puts [bitmap] onto the [clipboard], the system's.
 *
 * @throws IOException with a sentence for the person, when there is none or another program holds it.
 */
internal fun copyImage(bitmap: ImageBitmap, clipboard: () -> Clipboard = ::systemClipboard) = copyImage(bitmap.toAwtImage(), clipboard)

/** Draws [graphs] as a figure of the visible range, and puts its picture onto the [clipboard], the system's. */
internal fun copyGraphs(viewer: Viewer, graphs: List<GraphSpec>, clipboard: () -> Clipboard = ::systemClipboard) {
    if (viewer.open == null) return sayNoLog(viewer)
    if (graphs.isEmpty()) return
    val options = FigureOptions(graphHeight = if (graphs.size == 1) LONE_HEIGHT else FigureOptions().graphHeight)
    val builder = FigureBuilder(viewer.drawnRecordings(), viewer.viewport.visible, options.width)
    val draw = { imageOf(svgOf(drawable(builder.build(graphs)), options), options.width, PICTURE_SCALE) }
    viewer.tasks.run("Copying the picture", { copyImage(draw(), clipboard) }) {
        val what = graphs.singleOrNull()?.let { "“${it.title}”" } ?: "${graphs.size} graphs"
        viewer.notices.say("Copied a picture of $what; paste it where you like.")
    }
}

private fun systemClipboard() = Toolkit.getDefaultToolkit().systemClipboard

private fun copyImage(image: Image, clipboard: () -> Clipboard) {
    try {
        clipboard().setContents(Picture(image), null)
    } catch (e: HeadlessException) {
        throw IOException("There is no clipboard here; save the figure as a file instead.", e)
    } catch (e: IllegalStateException) {
        throw IOException("Another program holds the clipboard; try it again.", e)
    }
}

private class Picture(private val image: Image) : Transferable {
    override fun getTransferDataFlavors(): Array<DataFlavor> = arrayOf(DataFlavor.imageFlavor)

    override fun isDataFlavorSupported(flavor: DataFlavor): Boolean = flavor == DataFlavor.imageFlavor

    override fun getTransferData(flavor: DataFlavor): Any =
        if (isDataFlavorSupported(flavor)) image else throw UnsupportedFlavorException(flavor)
}

private const val LONE_HEIGHT = 320
