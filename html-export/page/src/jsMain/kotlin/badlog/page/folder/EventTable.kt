package badlog.page.folder

import badlog.core.analysis.EventLog
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.focusInPlace
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Scene
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.panel.eventRows
import badlog.viewer.shown.search.Query
import badlog.viewer.text.countOf
import badlog.viewer.text.countText
import org.w3c.dom.HTMLElement

/** The events of a topic, see [eventRows]. */
internal class EventTable(private val log: EventLog, private val scene: Scene) {
    private val all = EventTimeline.of(listOf(log))
    private var found = all
    private var limit = PAGE
    private val nodes = PartNodes(scene.palette) { if (scene.xAxis.range != null) scene.store.send(it) }
    private lateinit var count: HTMLElement
    private lateinit var scroll: HTMLElement
    private lateinit var body: HTMLElement
    private lateinit var more: HTMLElement

    val element: HTMLElement = element("section", "events card") {
        setAttribute("data-name", log.name)
        add("header", "graph-head") {
            add("h3", "graph-title", log.title).title = log.name
            count = add("span", "unit")
        }
        if (all.size == 0) add("p", "unit", "No events.")
        scroll = add("div", "events-scroll") {
            isHidden = all.size == 0
            setAttribute("tabindex", "0")
            setAttribute("role", "group")
            setAttribute("aria-label", "Events of ${log.name}")
            body = add("div")
            more = addButton("more text-button", "") {
                limit += PAGE
                show()
            }
        }
    }

    init {
        show()
    }

    /** The number of listed events. */
    val foundCount: Int get() = found.size

    /** Focuses the list, so that keys scroll it. */
    fun focus() = scroll.focusInPlace()

    /** Shows the events that match [query], and returns their number. */
    fun filter(query: Query): Int {
        found = all.matching(query)
        limit = PAGE
        show()
        element.isHidden = found.size == 0 && !query.isEmpty
        return found.size
    }

    private fun show() {
        count.showText(countOf(found.size, all.size, "event"))
        body.patch(nodes.of(listOf(eventRows(log.name, found, scene.times, limit))))
        more.isHidden = found.size <= limit
        more.showText("Show more (${countText(found.size - limit)} left)")
    }

    private companion object {
        /** The number of rows added at a time; a browser is slow with more than a few thousand. */
        const val PAGE = 300
    }
}
