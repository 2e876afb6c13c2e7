package badlog.viewer.menu

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
import androidx.compose.ui.layout.LayoutCoordinates
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.unit.toSize

/**
 * [opener], most often a button, and below it what [menu] has while [isOpen]. Escape and a press elsewhere call [onClose]; the press still
 * does what it is for. The menu has the keyboard while it is open; then it is [opener]'s again.
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
        ShowMenu(anchor, takesKeys = true, onClose, { if (place?.isAttached == true) focus.requestFocus() }, menu)
    }
}

/**
 * Has the [MenuLayer] show [content] beside [anchor], a place in the window, as long as this is composed.
 *
 * @param onClosed is called when that ends, but not when a press elsewhere has closed it.
 */
@Composable
internal fun ShowMenu(anchor: Rect, takesKeys: Boolean, onClose: () -> Unit, onClosed: () -> Unit, content: @Composable () -> Unit) {
    ClosesByEscape(isOpen = true, onClose)
    val menus = LocalOpenMenus.current
    val latest by rememberUpdatedState(content)
    val close by rememberUpdatedState(onClose)
    val closed by rememberUpdatedState(onClosed)
    val shown = remember { OpenMenu(takesKeys, { close() }) { latest() } }
    SideEffect { shown.anchor = anchor }
    DisposableEffect(menus) {
        menus.shown += shown
        onDispose {
            menus.shown -= shown
            if (!shown.wasLeft) closed()
        }
    }
}
