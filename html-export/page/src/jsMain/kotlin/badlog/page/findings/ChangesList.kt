package badlog.page.findings

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.rules.Finding
import org.w3c.dom.HTMLElement

/**
 * Returns a list of the [differences] from the matches before; null if there are none.
 *
 * @param onShow called with the one that a person wants to see.
 */
internal fun changesList(differences: List<Finding>, onShow: (Finding) -> Unit): HTMLElement? = if (differences.isEmpty()) {
    null
} else {
    element("section", "changes") {
        setAttribute("aria-label", "Unlike the matches before")
        add("h3", "", "Unlike the matches before")
        add("ul") {
            for (difference in differences) {
                add("li").addButton("text-button", difference.text, "Draw it over the match before. ${difference.next}".trim()) {
                    onShow(difference)
                }
            }
        }
    }
}
