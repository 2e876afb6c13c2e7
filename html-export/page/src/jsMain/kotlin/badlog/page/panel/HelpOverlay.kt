package badlog.page.panel

import badlog.page.dom.Dialog
import badlog.page.dom.add
import badlog.viewer.input.GRAPH_GESTURES
import badlog.viewer.input.HelpLine
import badlog.viewer.input.KeyAction
import badlog.viewer.input.SEARCH_HELP
import badlog.viewer.input.ScreenKey
import org.w3c.dom.HTMLElement

/** The dialog that lists the keys and gestures. */
internal class HelpOverlay {
    private val dialog = Dialog("help", title = "Keys and gestures") {}
    private var hasContent = false

    val element: HTMLElement = dialog.element

    private fun HTMLElement.addContent() {
        val lines = GRAPH_GESTURES + KeyAction.entries.map { it.help } + OTHERS + ScreenKey.entries.map { it.helpOnPage } + SEARCH_HELP
        for ((group, ofGroup) in lines.groupBy { it.group }) {
            add("h3", "", group)
            add("dl", "help-keys") { for (line in ofGroup) addLine(line) }
        }
    }

    private fun HTMLElement.addLine(line: HelpLine) {
        add("dt") { for (key in line.how.split(", ", "  ")) add("kbd", "", key) }
        add("dd", "", line.meaning)
    }

    /** Opens or closes the dialog. */
    fun toggle() {
        if (dialog.isOpen) return dialog.close()
        if (!hasContent) element.addContent()
        hasContent = true
        dialog.open()
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
            HelpLine("Page", "Esc", "Cancel a drag, or one at a time: the search, the evidence, the cursors"),
        )
    }
}
