package badlog.window.menu

import androidx.compose.foundation.LocalIndication
import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isAltPressed
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import androidx.compose.ui.input.key.utf16CodePoint
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.InterceptPlatformTextInput
import androidx.compose.ui.platform.PlatformTextInputInterceptor
import badlog.viewer.input.HelpLine
import badlog.viewer.input.KeyAction
import badlog.viewer.input.KeyStroke
import badlog.viewer.input.ScreenKey

/**
 * Detects whether a person is typing into a text field, and passes keys to commands otherwise. A field lets presses of letters through to
 * the window, so an unused press proves nothing.
 */
@OptIn(ExperimentalComposeUiApi::class)
internal class Keyboard {
    /** Whether a text field has the keyboard focus. */
    val isTyping: Boolean get() = fields > 0

    /** The menus that Escape closes before it does anything else. */
    val menus = OpenMenus()

    private var fields = 0

    private val interceptor = PlatformTextInputInterceptor { request, nextHandler ->
        fields++
        try {
            nextHandler.startInputMethod(request)
        } finally {
            fields--
        }
    }

    /** Whether the focused element is framed: from the first Tab until the mouse is used again. */
    var showsFocus: Boolean by mutableStateOf(false)
        private set

    /** Shows [content] and watches its text fields. */
    @Composable
    fun Watch(content: @Composable () -> Unit) {
        val ring = remember { FocusRing(this) }
        CompositionLocalProvider(LocalIndication provides ring) {
            InterceptPlatformTextInput(interceptor) {
                Box(Modifier.watchesPresses(), propagateMinConstraints = true) { MenuLayer(menus, content) }
            }
        }
    }

    private fun Modifier.watchesPresses() = pointerInput(Unit) {
        awaitPointerEventScope {
            while (true) if (awaitPointerEvent(PointerEventPass.Initial).type == PointerEventType.Press) showsFocus = false
        }
    }

    /**
     * Runs the first of [commands] that matches [event]; returns false if none does. While a person is typing, only commands with Ctrl, F1
     * to F12, or Escape match. Use it for `onKeyEvent` of the window, which receives keys that no field has used.
     */
    fun dispatch(event: KeyEvent, commands: List<Command>): Boolean {
        if (event.type != KeyEventType.KeyDown) return false
        val isCtrl = event.isCtrlPressed || event.isMetaPressed
        if (isTyping && !isCtrl && event.key !in KEYS_WHILE_TYPING) return false
        val command = commands.firstOrNull { command ->
            command.keys.any {
                it.key == event.key && it.ctrl == isCtrl && it.shift == event.isShiftPressed && it.alt == event.isAltPressed
            }
        }
        command?.action?.invoke()
        return command != null
    }

    /**
     * Passes Space to [commands] even after a click on a button, which would take it for another click. Enter still presses the button.
     * Escape closes the open menu, and a context menu receives its keys. Use it for `onPreviewKeyEvent` of the window.
     */
    fun dispatchFirst(event: KeyEvent, commands: List<Command>): Boolean {
        if (event.isDigitWithCtrl) return true
        if (event.key == Key.Tab && event.type == KeyEventType.KeyDown) showsFocus = true
        if (event.key == Key.Escape && event.type == KeyEventType.KeyDown && menus.closeLast()) return true
        if (event.type == KeyEventType.KeyDown && menus.handle(event.key)) return true
        if (event.key != Key.Spacebar || isTyping || event.isAltPressed) return false
        dispatch(event, commands)
        // The button must not receive the release of the key either.
        return true
    }

    private companion object {
        val KEYS_WHILE_TYPING = setOf(
            Key.Escape, Key.F1, Key.F2, Key.F3, Key.F4, Key.F5, Key.F6, Key.F7, Key.F8, Key.F9, Key.F10, Key.F11, Key.F12,
        )
    }
}

/** Whether the event is the character that some systems report after Ctrl and a digit. A field would take it for text. */
private val KeyEvent.isDigitWithCtrl: Boolean
    get() = type == KeyEventType.Unknown && isCtrlPressed && utf16CodePoint in '0'.code..'9'.code

/**
 * A keyboard command, as listed in the help.
 *
 * @property keys the keys; each does the same.
 * @property meaning its effect, for the help.
 * @property group its heading in the help.
 */
internal class Command(val group: String, val meaning: String, val keys: List<KeyPress>, val action: () -> Unit) {
    /** Creates the command for [action], which pages also have; it calls [run]. */
    constructor(action: KeyAction, run: () -> Unit) : this(action.group, action.meaning, action.keys.flatMap(::pressesOf), run)

    /** Creates the command for [key], which works outside the graphs and which pages also have; it calls [run]. */
    constructor(key: ScreenKey, run: () -> Unit) : this(key.group, key.meaning, pressesOf(key.key), run)

    /** Its line in the help. */
    // Which characters need Shift depends on the keyboard.
    val help: HelpLine
        get() = HelpLine(group, keys.map { if (it.label in "+=<>?") it.label else it.text }.distinct().joinToString("  "), meaning)
}

/** Returns the key presses for [stroke]. */
private fun pressesOf(stroke: KeyStroke): List<KeyPress> {
    // Whether a key with a plus needs Shift depends on the keyboard.
    val shifts = if (stroke.key == "+") listOf(false, true) else listOf(stroke.shift)
    return shifts.flatMap { shift -> KEYS.getValue(stroke.key).map { KeyPress(it, stroke.key, stroke.ctrl, shift, stroke.alt) } }
}

private val KEYS = mapOf(
    "←" to listOf(Key.DirectionLeft),
    "→" to listOf(Key.DirectionRight),
    "+" to listOf(Key.Plus, Key.Equals, Key.NumPadAdd),
    "-" to listOf(Key.Minus, Key.NumPadSubtract),
    "0" to listOf(Key.Zero),
    "Home" to listOf(Key.MoveHome),
    "Backspace" to listOf(Key.Backspace),
    "[" to listOf(Key.LeftBracket),
    "]" to listOf(Key.RightBracket),
    "B" to listOf(Key.B),
    "E" to listOf(Key.E),
    "F" to listOf(Key.F),
    "M" to listOf(Key.M),
    "N" to listOf(Key.N),
    "G" to listOf(Key.G),
    "H" to listOf(Key.H),
    "P" to listOf(Key.P),
    "W" to listOf(Key.W),
    "Y" to listOf(Key.Y),
    "Z" to listOf(Key.Z),
    "↑" to listOf(Key.DirectionUp),
    "↓" to listOf(Key.DirectionDown),
    "V" to listOf(Key.V),
    "," to listOf(Key.Comma),
    "." to listOf(Key.Period),
    "A" to listOf(Key.A),
    "I" to listOf(Key.I),
    "Page up" to listOf(Key.PageUp),
    "Page down" to listOf(Key.PageDown),
)

/** A key with the modifiers that must be held; [ctrl] is the command key on a Mac. */
internal data class KeyPress(
    val key: Key,
    val label: String,
    val ctrl: Boolean = false,
    val shift: Boolean = false,
    val alt: Boolean = false,
) {
    /** Its text in the help: `Ctrl+Shift+S`. */
    val text: String get() = listOfNotNull("Ctrl".takeIf { ctrl }, "Alt".takeIf { alt }, "Shift".takeIf { shift }, label).joinToString("+")
}
