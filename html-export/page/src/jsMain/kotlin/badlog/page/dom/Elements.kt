package badlog.page.dom

import badlog.viewer.input.ScreenKey
import badlog.viewer.panel.PanelRoom
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.dom.asList
import org.w3c.dom.events.Event
import org.w3c.dom.events.KeyboardEvent
import org.w3c.files.File

/** Whether the screen is narrow, as defined by the style sheet. */
internal val isNarrow: Boolean get() = window.innerWidth <= 760

/** The room for a panel above the graphs. */
internal val panelRoom: PanelRoom get() = if (isNarrow) PanelRoom.NARROW else PanelRoom.SHARED

/** Returns a new element. [text] becomes a text node, so that nothing in a file can become markup. */
internal fun element(tag: String, className: String = "", text: String = "", build: HTMLElement.() -> Unit = {}): HTMLElement {
    val element = document.createElement(tag).unsafeCast<HTMLElement>()
    if (className.isNotEmpty()) element.className = className
    if (text.isNotEmpty()) element.textContent = text
    element.build()
    return element
}

/** Adds an element as the last child of this one. */
internal fun HTMLElement.add(tag: String, className: String = "", text: String = "", build: HTMLElement.() -> Unit = {}): HTMLElement {
    val child = element(tag, className, text, build)
    appendChild(child)
    return child
}

/**
 * Adds [name] in one line as the last child of this element, and returns the element with its text. If there is no room for all of it, its
 * beginning is cut off, because long names differ at their ends.
 */
internal fun HTMLElement.addName(name: String = "", className: String = ""): HTMLElement =
    // Within its own direction, a slash at the beginning stays there.
    add("span", "cut-name $className".trim()).add("bdi", "", name)

/** Adds a button as the last child of this one. */
internal fun HTMLElement.addButton(className: String, text: String, hint: String = "", onClick: () -> Unit): HTMLElement =
    add("button", className, text) {
        setAttribute("type", "button")
        if (hint.isNotEmpty()) title = hint
        addEventListener("click", { onClick() })
    }

/** Adds a button that shows only an icon; [hint] is its accessible name. */
internal fun HTMLElement.addIconButton(className: String, icon: Icon, hint: String, onClick: () -> Unit): HTMLElement =
    addButton("icon-button $className", "", hint, onClick).apply {
        setAttribute("aria-label", hint)
        appendChild(icon.draw())
    }

/** Adds a field for a text, called [label]. */
internal fun HTMLElement.addTextField(className: String, id: String, label: String, placeholder: String = ""): HTMLInputElement =
    add("input", className) {
        this.id = id
        setAttribute("autocomplete", "off")
        setAttribute("spellcheck", "false")
        setAttribute("aria-label", label)
        setAttribute("placeholder", placeholder)
    }.unsafeCast<HTMLInputElement>()

/** Returns a hidden field, called [label], which asks for files when it is clicked; [onFiles] is called with the chosen ones. */
internal fun fileInput(id: String, label: String, types: String = "", onFiles: (List<File>) -> Unit): HTMLInputElement =
    element("input").unsafeCast<HTMLInputElement>().apply {
        type = "file"
        if (id.isNotEmpty()) this.id = id
        accept = types
        isHidden = true
        setAttribute("aria-label", label)
        addEventListener("change", {
            // The browser's own list becomes empty with the value.
            val chosen = files?.asList().orEmpty().toList()
            value = ""
            onFiles(chosen)
        })
    }

/** Whether the element is invisible and not in the tab order. */
internal var HTMLElement.isHidden: Boolean
    get() = hasAttribute("hidden")
    set(value) {
        // The browser recalculates styles after each write, even of the same value.
        if (value != isHidden) {
            if (value) setAttribute("hidden", "") else removeAttribute("hidden")
        }
    }

/** Whether a button cannot currently be pressed. */
internal var HTMLElement.isDisabled: Boolean
    get() = hasAttribute("disabled")
    set(value) {
        if (value) setAttribute("disabled", "") else removeAttribute("disabled")
    }

/** Replaces the text, but only if it differs, because the browser repeats its layout after each change. */
internal fun HTMLElement.showText(text: String) {
    if (textContent != text) textContent = text
}

/**
 * Scrolls to this element, and again once the page is laid out. Elements in between are laid out only near the screen, and may be taller
 * than estimated. Only this page scrolls, not a page that shows it in a frame.
 */
internal fun Element.bringIntoSight() {
    fun scroll() {
        val below = window.getComputedStyle(document.documentElement!!).asDynamic().scrollPaddingTop.unsafeCast<String>()
        val top = window.scrollY + getBoundingClientRect().top - (below.removeSuffix("px").toDoubleOrNull() ?: 0.0)
        window.asDynamic().scrollTo(json("top" to top, "behavior" to "instant"))
    }
    scroll()
    window.requestAnimationFrame { window.requestAnimationFrame { scroll() } }
}

/** Focuses this element without scrolling. */
internal fun Element.focusInPlace() = asDynamic().focus(json("preventScroll" to true)).unsafeCast<Unit>()

/** Whether the key is typed into a field, or pressed in a dialog. */
internal val KeyboardEvent.isTyped: Boolean
    get() = target.unsafeCast<Element?>()?.closest("dialog, input:not([type=checkbox], [type=radio]), textarea, select") != null

/** The pressed key if it is a shortcut outside the graphs; null for other keys, and for keys typed into a field. */
internal val KeyboardEvent.screenKey: ScreenKey?
    get() = if (isTyped || ctrlKey || metaKey) null else ScreenKey.onPage(PAGE_KEYS[key] ?: key.uppercase(), shiftKey, altKey)

private val PAGE_KEYS = mapOf("PageUp" to "Page up", "PageDown" to "Page down")

/** Reserves the Escape key for one activity while it lasts: the key calls [cancel], which ends the activity. */
internal class EscapeKey(private val cancel: () -> Unit) {
    private val listener: (Event) -> Unit = { event ->
        if (event.unsafeCast<KeyboardEvent>().key == "Escape") {
            event.stopImmediatePropagation()
            cancel()
        }
    }

    /** Reserves the key. */
    fun take() = document.addEventListener("keydown", listener, true)

    /** Releases the key. */
    fun giveBack() = document.removeEventListener("keydown", listener, true)
}
