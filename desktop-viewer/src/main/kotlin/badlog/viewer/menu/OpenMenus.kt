package badlog.viewer.menu

import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.ProvidableCompositionLocal
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.staticCompositionLocalOf

/** The menus that are open. Nothing in a menu has the keyboard, so that it hears no Escape by itself. */
internal class OpenMenus {
    private val closers = ArrayList<() -> Unit>()

    /** Closes the one that was opened last; false when none is open. */
    fun closeLast(): Boolean {
        val close = closers.removeLastOrNull() ?: return false
        close()
        return true
    }

    fun add(close: () -> Unit) {
        closers += close
    }

    fun remove(close: () -> Unit) {
        closers -= close
    }
}

/** The open menus of the window. */
internal val LocalOpenMenus: ProvidableCompositionLocal<OpenMenus> = staticCompositionLocalOf { OpenMenus() }

/** Has Escape call [onClose] while [isOpen]. */
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
