package badlog.page.panel

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.viewer.input.Action
import badlog.viewer.input.GRAPH_GESTURES
import badlog.viewer.input.HelpLine
import badlog.viewer.input.SEARCH_HELP
import org.w3c.dom.HTMLElement

/** The keys and gestures, in a dialog. */
internal class HelpOverlay {
    val element: HTMLElement = element("dialog", "help") {
        id = "help"
        setAttribute("aria-label", "Keys and gestures")
        // A click on the dialog itself is outside its content.
        addEventListener("click", { if (it.target == this) close() })
    }

    private fun HTMLElement.addContent() {
        add("div", "help-head") {
            add("h2", "", "Keys and gestures")
            addIconButton("", Icon.CLOSE, "Close") { close() }
        }
        val lines = GRAPH_GESTURES + Action.entries.map { it.help } + OTHERS + SEARCH_HELP
        for ((group, ofGroup) in lines.groupBy { it.group }) {
            add("h3", "", group)
            add("dl", "help-keys") { for (line in ofGroup) addLine(line) }
        }
    }

    private fun HTMLElement.addLine(line: HelpLine) {
        add("dt") { for (key in line.how.split(", ", "  ")) add("kbd", "", key) }
        add("dd", "", line.meaning)
    }

    /** Opens or closes it. */
    fun toggle() {
        if (element.firstChild == null) element.addContent()
        if (element.hasAttribute("open")) close() else element.asDynamic().showModal()
    }

    private fun close() {
        element.asDynamic().close()
    }

    private companion object {
        val OTHERS = listOf(
            HelpLine(
                "On the graphs",
                "Touch",
                "Tap pins the cursor, a long press sets the second; a sideways drag zooms or pans, a double tap shows everything.",
            ),
            HelpLine("Board", "Drag a title", "Puts the graph there on the board; on another graph, draws both in one."),
            HelpLine("Page", "/", "Search"),
            HelpLine("Page", "Esc", "Clear the search, hide the cursors, cancel a drag"),
            HelpLine("Page", "?", "This help"),
        )
    }
}
