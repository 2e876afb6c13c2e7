package badlog.viewer.app

import androidx.compose.ui.input.key.Key

/**
 * Something the keyboard does. The help sheet lists them as they are here.
 *
 * @property keys what to press; each does the same.
 * @property meaning what it does, as the help sheet says it.
 * @property group under which heading.
 */
internal class Command(val group: String, val meaning: String, val keys: List<KeyPress>, val action: () -> Unit)

/** A key with the modifiers that must be held; [ctrl] is the command key on a Mac. */
internal data class KeyPress(val key: Key, val label: String, val ctrl: Boolean = false, val shift: Boolean = false) {
    /** As the help sheet writes it: `Ctrl+Shift+S`. */
    val text: String get() = listOfNotNull("Ctrl".takeIf { ctrl }, "Shift".takeIf { shift }, label).joinToString("+")
}
