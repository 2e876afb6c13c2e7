package badlog.viewer.topic

import androidx.compose.foundation.draganddrop.dragAndDropSource
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.Modifier
import androidx.compose.ui.draganddrop.DragAndDropTransferAction
import androidx.compose.ui.draganddrop.DragAndDropTransferData
import androidx.compose.ui.draganddrop.DragAndDropTransferable
import java.awt.datatransfer.StringSelection

/** Lets what it modifies be dragged as the signals that [names] gives when the drag begins: plain text, a name in each line. */
@OptIn(ExperimentalComposeUiApi::class)
internal fun Modifier.draggedAsSignals(names: () -> List<String>): Modifier = dragAndDropSource {
    DragAndDropTransferData(
        transferable = DragAndDropTransferable(StringSelection(names().joinToString("\n"))),
        supportedActions = listOf(DragAndDropTransferAction.Copy),
    )
}
