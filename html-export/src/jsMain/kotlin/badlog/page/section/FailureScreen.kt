package badlog.page.section

import badlog.page.dom.add
import badlog.page.dom.element
import org.w3c.dom.HTMLElement

/** What stands on the page instead of a recording that cannot be shown. */
internal fun failureScreen(title: String, explanation: String, tools: HTMLElement? = null): HTMLElement = element("div", "screen failure") {
    setAttribute("role", "alert")
    add("p", "screen-title", title)
    add("p", "screen-text", explanation)
    if (tools != null) appendChild(tools)
}
