package badlog.page.dom

import org.w3c.dom.Element
import org.w3c.dom.events.KeyboardEvent

/** Whether the key is typed into a field, or pressed in a dialog. */
internal val KeyboardEvent.isTyped: Boolean
    get() = target.unsafeCast<Element?>()?.closest("dialog, input:not([type=checkbox], [type=radio]), textarea, select") != null

/** Returns whether it is the lowercase [letter] alone, and is not typed into a field. */
internal fun KeyboardEvent.isPlain(letter: String): Boolean =
    key.lowercase() == letter && !ctrlKey && !metaKey && !altKey && !shiftKey && !isTyped
