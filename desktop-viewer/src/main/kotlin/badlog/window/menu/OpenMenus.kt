package badlog.window.menu

import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.ProvidableCompositionLocal
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateListOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.key.Key

/** The open menus, and other elements that Escape closes first. */
internal class OpenMenus {
    private val closers = ArrayList<() -> Unit>()

    /** The menus that [MenuLayer] shows, the latest last. */
    val shown: MutableList<OpenMenu> = mutableStateListOf()

    /** Closes the menu or element that was opened last. Returns false if none is open. */
    fun closeLast(): Boolean {
        val close = closers.removeLastOrNull() ?: return false
        close()
        return true
    }

    /** Handles a press of the mouse at [place] in the window. Closes the open menus, latest first, until one contains it. */
    fun pressed(place: Offset) {
        for (menu in shown.asReversed().toList()) {
            // A press on the element that opened a menu is left to that element, which closes the menu itself.
            if (place in menu.bounds || place in menu.anchor) return
            menu.wasLeft = true
            menu.close()
        }
    }

    /** Passes a press of [key] to the menu that was opened last. Returns whether that menu used it. */
    fun handle(key: Key): Boolean = shown.lastOrNull()?.onKey?.invoke(key) ?: false

    /** Adds [close], which Escape calls before the ones added earlier. */
    fun add(close: () -> Unit) {
        closers += close
    }

    /** Removes [close], because its element is no longer open. */
    fun remove(close: () -> Unit) {
        closers -= close
    }
}

/**
 * An open menu.
 *
 * @property takesKeys whether it has the keyboard focus while it is open.
 * @property close closes it.
 * @property onKey handles a key that is pressed; returns whether the menu used it.
 * @property content its content.
 */
internal class OpenMenu(val takesKeys: Boolean, val close: () -> Unit, val onKey: (Key) -> Boolean, val content: @Composable () -> Unit) {
    /** The place in the window of the element that opened it. */
    var anchor: Rect by mutableStateOf(Rect.Zero)

    /** Its own place in the window. */
    var bounds: Rect = Rect.Zero

    /** Whether a press elsewhere closed it. */
    var wasLeft: Boolean = false
}

/** The open menus of the window. */
internal val LocalOpenMenus: ProvidableCompositionLocal<OpenMenus> = staticCompositionLocalOf { OpenMenus() }

/** Makes Escape call [onClose] while [isOpen]. */
@Composable
internal fun ClosesByEscape(isOpen: Boolean, onClose: () -> Unit) {
    if (!isOpen) return
    val menus = LocalOpenMenus.current
    val latest = rememberUpdatedState(onClose)
    DisposableEffect(menus) {
        val close = { latest.value() }
        menus.add(close)
        onDispose { menus.remove(close) }
    }
}
