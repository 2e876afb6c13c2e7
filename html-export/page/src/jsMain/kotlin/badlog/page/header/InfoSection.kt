package badlog.page.header

import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.core.recording.Severity
import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.embedded.About
import badlog.viewer.text.bytesText
import badlog.viewer.text.countText
import org.w3c.dom.HTMLElement

/** Returns the facts about the file of [view], with the topics of [recording], and its original header. */
internal fun infoSection(view: LogView, recording: Recording, about: About): HTMLElement = element("section", "info card") {
    id = "info"
    add("h2", "", "Info")
    add("dl", "values") {
        addFact("File", about.name)
        addFact("Size", bytesText(about.inflatedBytes) + if (about.isCompressed) ", inflated from gzip" else "")
        addFact("Format", recording.format.run { if (hasRows) title else "$title: each topic has its own times" })
        addFact("Topics", countText(recording.topics.size))
        addFact("Samples", samplesText(recording))
        addFact("X axis", view.xAxis.title)
        addFact("Page made by", "badlog ${about.version}".trim())
        addFact("Problems", problemsOf(view))
    }
    val header = recording.headerLine
    if (header != null) addHeader(header)
}

private fun HTMLElement.addFact(name: String, text: String) {
    add("div", "value-row") {
        add("dt", "", name)
        add("dd", "", text)
    }
}

private fun problemsOf(view: LogView): String {
    if (view.problems.isEmpty()) return "none: every cell was read as written"
    return countText(view.count(Severity.ERROR), "error") +
        " (data was lost), " + countText(view.count(Severity.WARNING), "warning") +
        " (kept, but perhaps not read as intended), " + countText(view.count(Severity.NOTE), "hint") +
        " (for information). The first ten of each kind and topic are listed, the others only counted."
}

private fun HTMLElement.addHeader(line: String) {
    add("details") {
        add("summary", "", "Header of the file (JSON)")
        // Filled when it is opened, because the header of a thousand topics takes long to lay out.
        addEventListener("toggle", {
            if (querySelector("pre") == null) add("pre", "header-json", indented(line)).setAttribute("tabindex", "0")
        })
    }
}

private fun indented(json: String): String = try {
    JSON.stringify(JSON.parse<dynamic>(json), null, 2)
} catch (_: Throwable) {
    json
}
