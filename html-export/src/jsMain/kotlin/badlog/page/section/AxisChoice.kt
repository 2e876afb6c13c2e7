package badlog.page.section

import badlog.page.dom.LocalStorage
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.plot.axis.over
import badlog.plot.axis.timeColumn
import badlog.recording.PathName
import badlog.recording.Recording
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/**
 * Over what a log is drawn that names no x axis: its rows, or its column of the time, as the person says. The browser remembers it for the
 * file.
 *
 * @param fileKey identifies the file.
 * @param mayAsk whether the page can be drawn over another axis than its exporter had.
 */
internal class AxisChoice(read: Recording, fileKey: String, mayAsk: Boolean) {
    private val key = "x:$fileKey"
    private val column = if (mayAsk) read.timeColumn() else null
    private val chosen = LocalStorage[key]

    /** The log over what was chosen. */
    val recording: Recording = if (column != null && chosen == TIME) read.over(column) else read

    /** Asks, or says what was chosen; null where there is nothing to choose. */
    val element: HTMLElement? = if (column == null || chosen == ROWS) {
        null
    } else {
        val name = PathName.baseNameOf(column.name)
        element("p", "axis-choice") {
            id = "axis-choice"
            add("span", "", if (chosen == TIME) "Drawn over “$name”." else "This log names no x axis. “$name” rises from row to row.")
            if (chosen != TIME) addButton("", "Draw over “$name”") { choose(TIME) }.id = "axis-time"
            addButton("text-button", if (chosen == TIME) "Use row numbers" else "Keep row numbers") { choose(ROWS) }.id = "axis-rows"
        }
    }

    // All of the page is made for its axis.
    private fun choose(what: String) {
        val isShown = recording.timeColumn() != null
        LocalStorage[key] = what
        if (isShown && what == ROWS) element?.remove() else window.location.reload()
    }

    private companion object {
        const val TIME = "time"
        const val ROWS = "rows"
    }
}
