package badlog.page.folder

import badlog.core.analysis.Event
import badlog.core.analysis.EventLog
import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.focusInPlace
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.search.Trait
import badlog.viewer.text.countOf
import badlog.viewer.text.countText
import org.w3c.dom.HTMLElement

/** An event log as a table of times and texts. Selecting an event moves the cursor to its time, and zooms there if requested. */
internal class EventTable(private val log: EventLog, private val scene: Scene) {
    private val haystacks = log.events.map { "${log.name} ${it.text}".lowercase() }
    private var found = log.events
    private var listed = 0
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
        if (log.events.isEmpty()) add("p", "unit", "No events.")
        scroll = add("div", "events-scroll") {
            isHidden = log.events.isEmpty()
            setAttribute("tabindex", "0")
            setAttribute("role", "group")
            setAttribute("aria-label", "Events of ${log.name}")
            add("table") {
                add("thead").add("tr") {
                    add("th", "event-time", scene.xAxis.title)
                    add("th", "", "Event")
                }
                body = add("tbody")
            }
            more = addButton("more text-button", "") { listMore() }
        }
    }

    init {
        showFound()
    }

    /** The number of listed events. */
    val foundCount: Int get() = found.size

    /** Focuses the list, so that keys scroll it. */
    fun focus() = scroll.focusInPlace()

    /** Shows the events that match [query], and returns their number. */
    fun filter(query: Query): Int {
        found = if (query.isEmpty) log.events else log.events.filterIndexed { i, _ -> query.matchesLowercase(haystacks[i], EVENT) }
        showFound()
        element.isHidden = found.isEmpty() && !query.isEmpty
        return found.size
    }

    private fun showFound() {
        body.textContent = ""
        listed = 0
        count.showText(countOf(found.size, log.events.size, "event"))
        listMore()
    }

    private fun listMore() {
        val end = minOf(found.size, listed + PAGE)
        for (i in listed until end) body.appendChild(row(found[i]))
        listed = end
        more.isHidden = listed == found.size
        more.showText("Show more (${countText(found.size - listed)} left)")
    }

    private fun row(event: Event): HTMLElement = element("tr", "event") {
        val time = scene.times.logged(event.x)
        setAttribute("data-x", event.x.toString())
        add("td", "event-time").addButton("event-go", time, "Move the cursor here") { scene.goTo(event.x) }
        add("td", "event-text") {
            add("span", "", event.text)
            addIconButton("event-zoom", Icon.SEARCH, "Zoom in on this event") { scene.zoomTo(event.x) }
        }
        addEventListener("click", { scene.goTo(event.x) })
    }

    private companion object {
        /** The number of rows created at a time; a browser is slow with more than a few thousand. */
        const val PAGE = 300
        val EVENT = setOf(Trait.EVENT)
    }
}
