package badlog.window.menu

import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.ContextMenuRepresentation
import androidx.compose.foundation.ContextMenuState
import androidx.compose.foundation.layout.Spacer
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.neverEqualPolicy
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.layout.LayoutCoordinates
import androidx.compose.ui.layout.onGloballyPositioned

/**
 * Context menus that look like all other menus of the window. The clicked element keeps the keyboard focus, as it may be a field; the menu
 * receives the keys before that element does.
 */
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
        // A right click elsewhere in the same area opens the menu again.
        key(status) {
            val isOfKeys = !status.rect.isEmpty
            val lines = items()
            var marked by remember { mutableIntStateOf(if (isOfKeys) 0 else NONE) }

            fun run(line: ContextMenuItem) {
                close()
                line.onClick()
            }

            fun handle(key: Key): Boolean {
                if (lines.isEmpty()) return false
                when (key) {
                    Key.DirectionDown -> marked = (marked + 1) % lines.size
                    Key.DirectionUp -> marked = (if (marked <= 0) lines.size else marked) - 1
                    Key.MoveHome -> marked = 0
                    Key.MoveEnd -> marked = lines.lastIndex
                    Key.Enter, Key.NumPadEnter -> lines.getOrNull(marked)?.let(::run)
                    else -> return false
                }
                return true
            }

            // A menu that keys opened is below its area, which would be covered otherwise.
            val corner = if (isOfKeys) status.rect.bottomLeft else status.rect.center
            ShowMenu(Rect(area.localToRoot(corner), Size.Zero), takesKeys = false, ::close, onClosed = {}, onKey = ::handle) {
                lines.forEachIndexed { i, line -> MenuLine(line.label, isMarked = i == marked) { run(line) } }
            }
        }
    }

    /** No line is marked yet. */
    private const val NONE = -1
}
