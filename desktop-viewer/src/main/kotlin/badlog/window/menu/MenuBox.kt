package badlog.window.menu

import androidx.compose.foundation.focusGroup
import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.neverEqualPolicy
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.layout.LayoutCoordinates
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.unit.toSize

/**
 * [opener], usually a button, with the content of [menu] below it while [isOpen]. Escape and a press elsewhere call [onClose]; the press
 * still has its usual effect. The menu has the keyboard focus while it is open; afterwards [opener] gets it back.
 */
@Composable
internal fun MenuBox(
    isOpen: Boolean,
    onClose: () -> Unit,
    modifier: Modifier = Modifier,
    menu: @Composable () -> Unit,
    opener: @Composable () -> Unit,
) {
    val focus = remember { FocusRequester() }
    var place: LayoutCoordinates? by remember { mutableStateOf(null, neverEqualPolicy()) }
    Box(modifier.onGloballyPositioned { place = it }.focusRequester(focus).focusGroup()) { opener() }
    if (isOpen) {
        val anchor = place?.takeIf { it.isAttached }?.let { Rect(it.positionInRoot(), it.size.toSize()) } ?: Rect.Zero
        ShowMenu(anchor, takesKeys = true, onClose, { if (place?.isAttached == true) focus.requestFocus() }, content = menu)
    }
}

/**
 * Makes the [MenuLayer] show [content] beside [anchor], a place in the window, while this is composed.
 *
 * @param onClosed called when that ends, but not if a press elsewhere closed it.
 * @param onKey called with each key that is pressed, before the focused element gets it; returns whether the menu used it.
 */
@Composable
internal fun ShowMenu(
    anchor: Rect,
    takesKeys: Boolean,
    onClose: () -> Unit,
    onClosed: () -> Unit,
    onKey: (Key) -> Boolean = { false },
    content: @Composable () -> Unit,
) {
    ClosesByEscape(isOpen = true, onClose)
    val menus = LocalOpenMenus.current
    val latest by rememberUpdatedState(content)
    val close by rememberUpdatedState(onClose)
    val closed by rememberUpdatedState(onClosed)
    val handle by rememberUpdatedState(onKey)
    val shown = remember { OpenMenu(takesKeys, { close() }, { handle(it) }) { latest() } }
    SideEffect { shown.anchor = anchor }
    DisposableEffect(menus) {
        menus.shown += shown
        onDispose {
            menus.shown -= shown
            if (!shown.wasLeft) closed()
        }
    }
}
