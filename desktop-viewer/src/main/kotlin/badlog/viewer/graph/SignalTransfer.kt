package badlog.viewer.graph

import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.draganddrop.DragAndDropEvent
import androidx.compose.ui.draganddrop.awtTransferable
import java.awt.datatransfer.DataFlavor
import java.awt.datatransfer.StringSelection
import java.awt.datatransfer.Transferable
import java.awt.datatransfer.UnsupportedFlavorException
import java.io.IOException

/** The signals [names] as what is dragged: their names as text, one on a line. */
internal fun signalTransfer(names: List<String>): Transferable = StringSelection(names.joinToString("\n"))

/** The names of signals that [transfer] has, as [signalTransfer] wrote them; empty for anything else, as files. */
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

/** Whether [transfer] may hold names of signals, as far as is known while it is still dragged. */
internal fun mayHoldSignals(transfer: Transferable): Boolean =
    transfer.isDataFlavorSupported(DataFlavor.stringFlavor) && !transfer.isDataFlavorSupported(DataFlavor.javaFileListFlavor)

/** The names of signals that are dropped by this event. */
@OptIn(ExperimentalComposeUiApi::class)
internal fun DragAndDropEvent.signalNames(): List<String> = signalNames(awtTransferable)

/** Whether names of signals may be what is dragged. */
@OptIn(ExperimentalComposeUiApi::class)
internal fun DragAndDropEvent.mayHoldSignals(): Boolean = mayHoldSignals(awtTransferable)
