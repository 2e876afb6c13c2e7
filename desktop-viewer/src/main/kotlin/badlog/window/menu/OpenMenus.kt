package badlog.window.menu

import androidx.compose.foundation.IndicationNodeFactory
import androidx.compose.foundation.interaction.FocusInteraction
import androidx.compose.foundation.interaction.InteractionSource
import androidx.compose.foundation.interaction.PressInteraction
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.ProvidableCompositionLocal
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateListOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.ContentDrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.node.CompositionLocalConsumerModifierNode
import androidx.compose.ui.node.DelegatableNode
import androidx.compose.ui.node.DrawModifierNode
import androidx.compose.ui.node.currentValueOf
import badlog.window.theme.LocalPalette
import kotlinx.coroutines.launch

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

/**
 * Frames the focused element if a person navigates by keys, see [Keyboard.showsFocus], and shades a pressed one. Material's own focus
 * indication is hardly visible.
 */
internal class FocusRing(private val keyboard: Keyboard) : IndicationNodeFactory {
    override fun create(interactionSource: InteractionSource): DelegatableNode = Ring(keyboard, interactionSource)

    override fun equals(other: Any?): Boolean = other is FocusRing && other.keyboard === keyboard

    override fun hashCode(): Int = keyboard.hashCode()

    private class Ring(private val keyboard: Keyboard, private val source: InteractionSource) :
        Modifier.Node(),
        DrawModifierNode,
        CompositionLocalConsumerModifierNode {
        private var isFocused by mutableStateOf(false)
        private var isPressed by mutableStateOf(false)

        override fun onAttach() {
            coroutineScope.launch {
                source.interactions.collect { interaction ->
                    when (interaction) {
                        is FocusInteraction.Focus -> isFocused = true
                        is FocusInteraction.Unfocus -> isFocused = false
                        is PressInteraction.Press -> isPressed = true
                        is PressInteraction.Release, is PressInteraction.Cancel -> isPressed = false
                    }
                }
            }
        }

        override fun ContentDrawScope.draw() {
            drawContent()
            val palette = currentValueOf(LocalPalette)
            if (isPressed) drawRect(palette.text.copy(alpha = PRESSED))
            if (!isFocused || !keyboard.showsFocus) return
            val line = WIDTH * density
            drawRoundRect(
                palette.accent,
                Offset(line / 2, line / 2),
                Size(size.width - line, size.height - line),
                CornerRadius(CORNER * density),
                Stroke(line),
            )
        }
    }
}

private const val WIDTH = 2f
private const val CORNER = 4f
private const val PRESSED = 0.08f
