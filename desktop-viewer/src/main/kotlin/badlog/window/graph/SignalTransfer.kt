package badlog.window.graph

import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.draganddrop.DragAndDropEvent
import androidx.compose.ui.draganddrop.awtTransferable
import java.awt.datatransfer.DataFlavor
import java.awt.datatransfer.StringSelection
import java.awt.datatransfer.Transferable
import java.awt.datatransfer.UnsupportedFlavorException
import java.io.IOException

/** Returns the signals [names] for dragging: their names as text, one per line. */
internal fun signalTransfer(names: List<String>): Transferable = StringSelection(names.joinToString("\n"))

/** Returns the names of signals that [transfer] has, as [signalTransfer] wrote them; empty for anything else, such as files. */
internal fun signalNames(transfer: Transferable): List<String> {
    if (!mayHoldSignals(transfer)) return emptyList()
    return try {
        (transfer.getTransferData(DataFlavor.stringFlavor) as? String).orEmpty().lines().filter { it.isNotEmpty() }
    } catch (_: UnsupportedFlavorException) {
        emptyList()
    } catch (_: IOException) {
        emptyList()
    }
}

/** Returns whether [transfer] may contain names of signals: its content is not known while it is being dragged. */
internal fun mayHoldSignals(transfer: Transferable): Boolean =
    transfer.isDataFlavorSupported(DataFlavor.stringFlavor) && !transfer.isDataFlavorSupported(DataFlavor.javaFileListFlavor)

/** Returns the names of signals that this event drops. */
@OptIn(ExperimentalComposeUiApi::class)
internal fun DragAndDropEvent.signalNames(): List<String> = signalNames(awtTransferable)

/** Returns whether the dragged content may be names of signals. */
@OptIn(ExperimentalComposeUiApi::class)
internal fun DragAndDropEvent.mayHoldSignals(): Boolean = mayHoldSignals(awtTransferable)
