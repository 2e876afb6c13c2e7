package badlog.page.findings

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.view.isPlaced
import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.viewer.text.fixedText
import badlog.viewer.text.word
import org.w3c.dom.HTMLElement

/**
 * Returns an incident as a row: its severity, then each of its sentences with the time of its evidence, with [decimals] decimals, and
 * what to look at next.
 *
 * @param pin called when a person wants to keep the graphs that show it.
 * @param go called when a person wants to see the place of a finding, or of the whole incident, which begins there.
 */
internal fun incidentRow(incident: Incident, decimals: Int, pin: () -> Unit, go: (Finding, isWhole: Boolean) -> Unit): HTMLElement =
    element("li", "incident") {
        incident.severity.word.let { add("span", "severity is-$it", it) }
        add("div", "incident-text") {
            for (sentence in incident.sentences) {
                add("p") {
                    val finding = sentence.finding
                    if (finding.isPlaced) {
                        addButton("event-go", fixedText(finding.time, decimals), "Zoom to it") { go(finding, false) }
                    } else {
                        add("span", "finding-whole", "whole log")
                    }
                    add("span", "", sentence.text)
                }
            }
            if (incident.next.isNotEmpty()) add("p", "incident-next", "Next: ${incident.next}")
        }
        addIconButton("pin", Icon.PIN, "Add its graphs to the board", pin)
        incident.sentences.map { it.finding }.firstOrNull { it.isPlaced }?.let { first ->
            addEventListener("click", { if (it.target.asDynamic().closest("button") == null) go(first, true) })
        }
    }
