package badlog.page.header

import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.core.recording.Severity
import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.embedded.About
import badlog.page.view.Scene
import badlog.viewer.text.bytesText
import badlog.viewer.text.countText
import badlog.viewer.text.durationText
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit
import org.w3c.dom.HTMLElement

/** Returns the facts about the file of [view], with the topics of [recording], and its original header. */
internal fun infoSection(view: LogView, recording: Recording, about: About): HTMLElement = element("section", "info card") {
    id = "info"
    add("h2", "", "Info")
    val facts = listOf(
        "File" to about.name,
        "Size" to bytesText(about.inflatedBytes) + if (about.isCompressed) ", inflated from gzip" else "",
        "Format" to recording.format.run { if (hasRows) title else "$title: each topic has its own times" },
        "Topics" to countText(recording.topics.size),
        "Samples" to samplesText(recording),
        "X axis" to view.xAxis.title,
        "Page made by" to "badlog ${about.version}".trim(),
        "Problems" to problemsOf(view),
    )
    add("ol", "values") {
        for ((name, text) in facts) {
            add("li", "value-row") {
                add("span", "cut-name", name)
                add("bdi", "value-text", text)
            }
        }
    }
    val header = recording.headerLine
    if (header != null) addHeader(header)
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

/** Returns the header: the file, facts about the [logged] recording, and the [tools]. */
internal fun pageHeader(scene: Scene, about: About, logged: Recording, tools: List<HTMLElement>): HTMLElement =
    element("header", "page-head") {
        val view = scene.view
        add("div", "page-title") {
            add("h1", "", view.title ?: about.name)
            add("p", "facts") {
                for (fact in factsOf(view, logged, about)) add("bdi", "fact", fact)
            }
        }
        add("div", "page-tools") { for (tool in tools) appendChild(tool) }
    }

private fun factsOf(view: LogView, logged: Recording, about: About): List<String> {
    val facts = ArrayList<String>()
    if (view.title != null) facts += about.name
    val width = view.xAxis.range?.run { endInclusive - start } ?: 0.0
    if (!view.xAxis.isIndex && width > 0) {
        facts += if (view.xAxis.unit == "s") durationText(width) else withUnit(numberText(width), view.xAxis.unit)
    }
    facts += countText(logged.topics.size, "topic")
    facts += samplesText(logged)
    facts += bytesText(about.inflatedBytes)
    return facts
}

/** Returns the number of samples as text, such as `7,500 samples each` if all topics share rows. */
internal fun samplesText(recording: Recording): String = if (recording.format.hasRows) {
    countText(recording.rowCount, "sample") + " each"
} else {
    countText(recording.sampleCount.toInt(), "sample")
}
