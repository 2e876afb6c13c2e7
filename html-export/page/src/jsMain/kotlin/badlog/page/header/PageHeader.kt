package badlog.page.header

import badlog.core.analysis.LogView
import badlog.core.recording.Recording
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
