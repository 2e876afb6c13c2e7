package badlog.page.folder

import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.viewer.text.countText
import org.w3c.dom.HTMLElement

/** The link to the first event log, which explains a recording but is far below its graphs. */
internal class EventsLink(private val folders: FolderList) {
    private lateinit var count: HTMLElement

    val element: HTMLElement = element("button", "events-link") {
        setAttribute("type", "button")
        title = "Go to the event log"
        add("span", "", "Events")
        count = add("span", "count")
        addEventListener("click", { go() })
    }

    init {
        update()
    }

    /** Shows the current number of events. */
    fun update() {
        val found = folders.sections.sumOf { section -> section.tables.sumOf { it.foundCount } }
        element.isHidden = found == 0
        count.showText(countText(found))
    }

    private fun go() {
        for (section in folders.sections) {
            val table = section.tables.firstOrNull { it.foundCount > 0 } ?: continue
            section.reveal(table.element)
            table.focus()
            return
        }
    }
}
