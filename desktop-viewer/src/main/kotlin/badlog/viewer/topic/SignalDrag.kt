package badlog.viewer.topic

import androidx.compose.foundation.draganddrop.dragAndDropSource
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.Modifier
import androidx.compose.ui.draganddrop.DragAndDropTransferAction
import androidx.compose.ui.draganddrop.DragAndDropTransferData
import androidx.compose.ui.draganddrop.DragAndDropTransferable
import androidx.compose.ui.graphics.Color
import badlog.viewer.graph.signalTransfer

/** Lets what it modifies be dragged as the signals that [names] gives when the drag begins. */
@OptIn(ExperimentalComposeUiApi::class)
internal fun Modifier.draggedAsSignals(color: Color, names: () -> List<String>): Modifier = dragAndDropSource(
    // Plain: a picture of the row would be recorded for every row.
    drawDragDecoration = { drawRoundRect(color, alpha = 0.4f) },
) {
    DragAndDropTransferData(
        transferable = DragAndDropTransferable(signalTransfer(names())),
        supportedActions = listOf(DragAndDropTransferAction.Copy),
    )
}
