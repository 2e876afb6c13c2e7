package badlog.page.findings

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.rules.Finding
import badlog.viewer.shown.folder.Changes
import org.w3c.dom.HTMLElement

/**
 * Returns a list of the differences in [changes]; null if there are none.
 *
 * @param onShow called with the one that a person wants to see.
 */
internal fun changesList(changes: Changes<*>, onShow: (Finding) -> Unit): HTMLElement? = if (changes.differences.isEmpty()) {
    null
} else {
    element("section", "changes") {
        setAttribute("aria-label", Changes.TITLE)
        add("h3", "", Changes.TITLE)
        add("ul") {
            for (difference in changes.differences) {
                add("li").addButton("text-button", difference.text, Changes.hintOf(difference)) {
                    onShow(difference)
                }
            }
        }
    }
}
