package badlog.page.dom

import badlog.viewer.input.MenuAnchor
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.HTMLElement
import org.w3c.dom.Node
import org.w3c.dom.asList
import org.w3c.dom.events.FocusEvent
import org.w3c.dom.events.KeyboardEvent

/**
 * An entry of a menu.
 *
 * @property label the text of the entry, which names its action.
 * @property isChecked whether it is currently on; null for a one-time action.
 */
internal class MenuEntry(val label: String, val isChecked: Boolean? = null, val action: () -> Unit)

/**
 * Opens a menu with [entries] beside [button], as a child of [host]. The host must not clip its content. Arrow keys move
 * within it; Escape, or moving the focus elsewhere, closes it.
 */
internal fun openMenu(button: HTMLElement, host: HTMLElement, entries: List<MenuEntry>) {
    val menu = element("div", "menu card") { setAttribute("role", "menu") }
    fun close() {
        button.setAttribute("aria-expanded", "false")
        menu.remove()
    }
    for (entry in entries) {
        menu.addButton("", entry.label) {
            close()
            button.focus()
            entry.action()
        }.apply {
            setAttribute("role", if (entry.isChecked == null) "menuitem" else "menuitemcheckbox")
            entry.isChecked?.let { setAttribute("aria-checked", it.toString()) }
        }
    }
    menu.addEventListener("keydown", { event ->
        val items = menu.children.asList().map { it.unsafeCast<HTMLElement>() }
        val at = items.indexOfFirst { it == document.activeElement }
        when (event.unsafeCast<KeyboardEvent>().key) {
            "ArrowDown" -> items[(at + 1) % items.size].focus()
            "ArrowUp" -> items[(at + items.size - 1) % items.size].focus()
            "Home" -> items.first().focus()
            "End" -> items.last().focus()
            "Escape" -> button.focus()
            "Tab", "Enter", " " -> return@addEventListener event.stopPropagation()
            else -> return@addEventListener
        }
        event.preventDefault()
        event.stopPropagation()
    })
    menu.addEventListener("focusout", { event ->
        val next = event.unsafeCast<FocusEvent>().relatedTarget.unsafeCast<Node?>()
        // A click outside the menu leaves nothing focused.
        if (next == null || !menu.contains(next)) window.setTimeout({ if (!menu.contains(document.activeElement)) close() }, 0)
    })
    button.setAttribute("aria-expanded", "true")
    host.appendChild(menu)
    val anchor = button.getBoundingClientRect().run { MenuAnchor(left.toFloat(), (top - GAP).toFloat(), (bottom + GAP).toFloat()) }
    val room = checkNotNull(document.documentElement)
    val (left, top) = anchor.cornerOf(menu.offsetWidth, menu.offsetHeight, room.clientWidth, room.clientHeight)
    val corner = (menu.offsetParent ?: room).getBoundingClientRect()
    menu.style.left = "${left - corner.left}px"
    menu.style.top = "${top - corner.top}px"
    menu.children.asList().first().unsafeCast<HTMLElement>().focus()
}

private const val GAP = 4
