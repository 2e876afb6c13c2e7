package badlog.window.menu

import androidx.compose.foundation.ContextMenuArea
import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.ContextMenuState
import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.layout.onSizeChanged
import androidx.compose.ui.unit.IntSize
import androidx.compose.ui.unit.toSize
import java.awt.event.KeyEvent.VK_CONTEXT_MENU

/**
 * [content] with a context menu of [items]. The right button opens it. The menu key or Shift+F10 open it while something in [content] has
 * the keyboard focus.
 */
@Composable
internal fun ContextArea(items: () -> List<ContextMenuItem>, content: @Composable () -> Unit) {
    val state = remember { ContextMenuState() }
    var size by remember { mutableStateOf(IntSize.Zero) }
    ContextMenuArea(items, state) {
        Box(
            Modifier
                .onSizeChanged { size = it }
                .onKeyEvent { event ->
                    val opens = opensMenu(event) && items().isNotEmpty()
                    if (opens) state.status = ContextMenuState.Status.Open(Rect(Offset.Zero, size.toSize()))
                    opens
                },
            propagateMinConstraints = true,
        ) { content() }
    }
}

private fun opensMenu(event: KeyEvent): Boolean =
    event.type == KeyEventType.KeyDown && (event.key == MENU_KEY || (event.key == Key.F10 && event.isShiftPressed))

private val MENU_KEY = Key(VK_CONTEXT_MENU)
