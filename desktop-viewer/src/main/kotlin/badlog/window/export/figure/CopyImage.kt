package badlog.window.export.figure

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.toAwtImage
import java.awt.HeadlessException
import java.awt.Image
import java.awt.Toolkit
import java.awt.datatransfer.Clipboard
import java.awt.datatransfer.DataFlavor
import java.awt.datatransfer.Transferable
import java.awt.datatransfer.UnsupportedFlavorException
import java.io.IOException

/**
 * Copies [bitmap] to the system's [clipboard].
 *
 * @throws IOException with a sentence for the user, if the clipboard is missing, or another program is using it.
 */
internal fun copyImage(bitmap: ImageBitmap, clipboard: () -> Clipboard = ::systemClipboard) = copyImage(bitmap.toAwtImage(), clipboard)

internal fun systemClipboard() = Toolkit.getDefaultToolkit().systemClipboard

/** Copies [image] to the [clipboard], like the other function. */
internal fun copyImage(image: Image, clipboard: () -> Clipboard) {
    try {
        clipboard().setContents(Picture(image), null)
    } catch (e: HeadlessException) {
        throw IOException("There is no clipboard here; save the figure as a file instead.", e)
    } catch (e: IllegalStateException) {
        throw IOException("Another program is using the clipboard; try again.", e)
    }
}

private class Picture(private val image: Image) : Transferable {
    override fun getTransferDataFlavors(): Array<DataFlavor> = arrayOf(DataFlavor.imageFlavor)

    override fun isDataFlavorSupported(flavor: DataFlavor): Boolean = flavor == DataFlavor.imageFlavor

    override fun getTransferData(flavor: DataFlavor): Any =
        if (isDataFlavorSupported(flavor)) image else throw UnsupportedFlavorException(flavor)
}
