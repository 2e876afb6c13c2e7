package badlog.page.dom

import org.w3c.dom.Element
import org.w3c.dom.events.KeyboardEvent

/** Whether it is typed into something, or pressed in a dialog. */
internal val KeyboardEvent.isTyped: Boolean
    get() = target.unsafeCast<Element?>()?.closest("dialog, input:not([type=checkbox], [type=radio]), textarea, select") != null

/** Returns whether it is the key of the lowercase [letter] alone, and not typed into something. */
internal fun KeyboardEvent.isPlain(letter: String): Boolean =
    key.lowercase() == letter && !ctrlKey && !metaKey && !altKey && !shiftKey && !isTyped
