package badlog.page.section

import badlog.analysis.LogView
import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.embedded.About
import badlog.page.text.bytesText
import badlog.page.text.countText
import badlog.page.text.durationText
import badlog.page.text.numberText
import badlog.page.text.withUnit
import badlog.page.view.Scene
import org.w3c.dom.HTMLElement

/** What file this is, and what can be done with it. */
internal fun pageHeader(scene: Scene, about: About, tools: List<HTMLElement>): HTMLElement =
    element("header", "page-head") {
        val view = scene.view
        add("div", "page-title") {
            add("h1", "", view.title ?: about.name)
            add("p", "facts") {
                for (fact in factsOf(view, scene, about)) add("span", "fact", fact)
            }
        }
        add("div", "page-tools") { for (tool in tools) appendChild(tool) }
    }

private fun factsOf(view: LogView, scene: Scene, about: About): List<String> {
    val facts = ArrayList<String>()
    if (view.title != null) facts += about.name
    if (view.recording.rowCount > 1 && view.xAxis.topic != null) {
        val width = scene.range.full.width
        facts += if (view.xAxis.unit == "s") durationText(width) else withUnit(numberText(width), view.xAxis.unit)
    }
    facts += countText(view.recording.topics.size, "topic")
    facts += countText(view.recording.rowCount, "sample") + " each"
    facts += bytesText(about.inflatedBytes)
    return facts
}
