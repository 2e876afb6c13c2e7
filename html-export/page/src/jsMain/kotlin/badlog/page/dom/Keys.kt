package badlog.page.dom

import badlog.viewer.input.ScreenKey
import org.w3c.dom.Element
import org.w3c.dom.events.KeyboardEvent

/** Whether the key is typed into a field, or pressed in a dialog. */
internal val KeyboardEvent.isTyped: Boolean
    get() = target.unsafeCast<Element?>()?.closest("dialog, input:not([type=checkbox], [type=radio]), textarea, select") != null

/** The pressed key if it is a shortcut outside the graphs; null for other keys, and for keys typed into a field. */
internal val KeyboardEvent.screenKey: ScreenKey?
    get() = if (isTyped || ctrlKey || metaKey) null else ScreenKey.onPage(PAGE_KEYS[key] ?: key.uppercase(), shiftKey, altKey)

private val PAGE_KEYS = mapOf("PageUp" to "Page up", "PageDown" to "Page down")
