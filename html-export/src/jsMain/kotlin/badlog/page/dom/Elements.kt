package badlog.page.dom

import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/** Whether the screen is one of the narrow ones, as the style sheet has it. */
internal val isNarrow: Boolean get() = window.innerWidth <= 760

/** Makes an element. [text] becomes a text node, so that nothing in a file can become markup. */
internal fun element(tag: String, className: String = "", text: String = "", build: HTMLElement.() -> Unit = {}): HTMLElement {
    val element = document.createElement(tag).unsafeCast<HTMLElement>()
    if (className.isNotEmpty()) element.className = className
    if (text.isNotEmpty()) element.textContent = text
    element.build()
    return element
}

/** Makes an element as the last child of this one. */
internal fun HTMLElement.add(tag: String, className: String = "", text: String = "", build: HTMLElement.() -> Unit = {}): HTMLElement {
    val child = element(tag, className, text, build)
    appendChild(child)
    return child
}

/** Makes a button as the last child of this one. */
internal fun HTMLElement.addButton(className: String, text: String, hint: String = "", onClick: () -> Unit): HTMLElement =
    add("button", className, text) {
        setAttribute("type", "button")
        if (hint.isNotEmpty()) title = hint
        addEventListener("click", { onClick() })
    }

/** Makes a button that shows only an icon; [hint] is its name for those who do not see it. */
internal fun HTMLElement.addIconButton(className: String, icon: Icon, hint: String, onClick: () -> Unit): HTMLElement =
    addButton("icon-button $className", "", hint, onClick).apply {
        setAttribute("aria-label", hint)
        appendChild(icon.draw())
    }

/** Takes an element out of sight and out of the tab order, or puts it back. */
internal var HTMLElement.isHidden: Boolean
    get() = hasAttribute("hidden")
    set(value) {
        // The browser styles again after each write, even of what was there.
        if (value != isHidden) {
            if (value) setAttribute("hidden", "") else removeAttribute("hidden")
        }
    }

/** Whether a button cannot be pressed now. */
internal var HTMLElement.isDisabled: Boolean
    get() = hasAttribute("disabled")
    set(value) {
        if (value) setAttribute("disabled", "") else removeAttribute("disabled")
    }

/** Replaces the text, but only where it differs: the browser lays out again after each change. */
internal fun HTMLElement.showText(text: String) {
    if (textContent != text) textContent = text
}
