package badlog.viewer.menu

import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.ContextMenuRepresentation
import androidx.compose.foundation.ContextMenuState
import androidx.compose.foundation.layout.Spacer
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.neverEqualPolicy
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.layout.LayoutCoordinates
import androidx.compose.ui.layout.onGloballyPositioned

/** The menus of the right button, like all others of the window. What was clicked keeps the keyboard: it may be a field. */
internal object ContextMenus : ContextMenuRepresentation {
    @Composable
    override fun Representation(state: ContextMenuState, items: () -> List<ContextMenuItem>) {
        val status = state.status as? ContextMenuState.Status.Open ?: return
        var place: LayoutCoordinates? by remember { mutableStateOf(null, neverEqualPolicy()) }
        Spacer(Modifier.onGloballyPositioned { place = it })
        val area = place?.takeIf { it.isAttached } ?: return
        fun close() {
            state.status = ContextMenuState.Status.Closed
        }
        // A click of the right button elsewhere on the same ground opens it anew.
        key(status) {
            ShowMenu(Rect(area.localToRoot(status.rect.center), Size.Zero), takesKeys = false, ::close, onClosed = {}) {
                for (item in items()) {
                    MenuLine(item.label) {
                        close()
                        item.onClick()
                    }
                }
            }
        }
    }
}
