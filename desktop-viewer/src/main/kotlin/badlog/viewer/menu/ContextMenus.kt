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

/** Context menus that look like all other menus of the window. The clicked element keeps the keyboard focus, as it may be a field. */
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
        // A right click elsewhere in the same area opens it again.
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
