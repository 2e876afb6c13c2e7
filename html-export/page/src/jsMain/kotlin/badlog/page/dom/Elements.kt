package badlog.page.dom

import badlog.viewer.panel.PanelRoom
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

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
