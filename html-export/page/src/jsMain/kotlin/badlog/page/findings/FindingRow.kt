package badlog.page.findings

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.view.end
import badlog.page.view.isPlaced
import badlog.rules.Finding
import badlog.viewer.text.countText
import badlog.viewer.text.fixedText
import badlog.viewer.text.word
import org.w3c.dom.HTMLElement

/**
 * One finding as a row: its severity, its time with [decimals] decimals, the rule, and its text.
 *
 * @param pin called when a person wants to keep the graphs that show it.
 * @param go called when a person wants to see the place.
 */
internal fun findingRow(finding: Finding, decimals: Int, pin: (Finding) -> Unit, go: (Finding) -> Unit): HTMLElement =
    element("li", "finding") {
        finding.severity.word.let { add("span", "severity is-$it", it) }
        if (finding.isPlaced) {
            addButton("event-go", timeText(finding, decimals), "Zoom to it") { go(finding) }
        } else {
            add("span", "finding-whole", "whole log")
        }
        add("span", "finding-text") {
            add("span", "finding-source", finding.rule)
            add("span", "", finding.text)
        }
        if (finding.spanCount > 1 && "${finding.spanCount}" !in finding.text) {
            add("span", "unit finding-count", "${countText(finding.spanCount)} times")
        }
        if (finding.evidence.isNotEmpty()) addIconButton("pin", Icon.PIN, "Add its graphs to the board") { pin(finding) }
        if (finding.isPlaced) {
            addEventListener("click", { if (it.target.asDynamic().closest("button") == null) go(finding) })
        }
    }

private fun timeText(finding: Finding, decimals: Int): String {
    val start = fixedText(finding.time, decimals)
    return if (finding.end > finding.time) "$start – ${fixedText(finding.end, decimals)}" else start
}
