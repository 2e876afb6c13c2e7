package badlog.page.header

import badlog.core.recording.PathName
import badlog.core.recording.Recording
import badlog.page.dom.LocalStorage
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.signals.over
import badlog.signals.timeColumn
import badlog.viewer.text.axisQuestion
import org.w3c.dom.HTMLElement

/**
 * The choice of the x axis for a log that does not name one: its rows, or its time column. The browser remembers it for the file.
 *
 * @param fileKey identifies the file.
 * @param onChange called when another axis was selected, because everything depends on it.
 * @param mayAsk whether the page can be drawn over a different axis than its exporter used.
 */
internal class AxisChoice(read: Recording, fileKey: String, mayAsk: Boolean, private val onChange: () -> Unit) {
    private val key = "x:$fileKey"
    private val column = if (mayAsk) read.timeColumn() else null
    private val chosen = LocalStorage[key]

    /** The log over the selected axis. */
    val recording: Recording = if (column != null && chosen == TIME) read.over(column) else read

    /** The element with the question or the selected axis; null if there is nothing to select. */
    val element: HTMLElement? = if (column == null || chosen == ROWS) {
        null
    } else {
        val name = PathName.baseNameOf(column.name)
        element("p", "axis-choice") {
            id = "axis-choice"
            add("span", "", if (chosen == TIME) "Drawn over “$name”." else axisQuestion(column))
            if (chosen != TIME) addButton("", "Draw over “$name”") { choose(TIME) }.id = "axis-time"
            addButton("text-button", if (chosen == TIME) "Use row numbers" else "Keep row numbers") { choose(ROWS) }.id = "axis-rows"
        }
    }

    private fun choose(what: String) {
        val isShown = recording.timeColumn() != null
        LocalStorage[key] = what
        if (isShown && what == ROWS) element?.remove() else onChange()
    }
}

private const val TIME = "time"
private const val ROWS = "rows"
