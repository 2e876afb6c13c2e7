package badlog.page.panel

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.viewer.shown.search.Query
import badlog.viewer.text.countText
import badlog.viewer.text.decimalsFor
import badlog.viewer.text.fixedText
import org.w3c.dom.HTMLElement

/** The notes about moments of the recording, each with a link to the moment; hidden if there are none. */
internal class NoteList(scene: Scene) {
    private val notes = scene.notes
    private val rows = ArrayList<HTMLElement>()
    private lateinit var count: HTMLElement

    val element: HTMLElement = element("section", "notes-written findings card") {
        id = "notes"
        setAttribute("aria-label", "Notes")
        val decimals = decimalsFor(scene.range.full.width)
        add("header", "graph-head") {
            add("h2", "findings-title", "Notes")
            count = add("span", "unit")
        }
        add("ul", "note-rows") {
            for (note in notes) {
                rows += add("li", "note-row") {
                    addButton("event-go", fixedText(note.x, decimals), "Zoom to it") { scene.zoomTo(note.x, note.x) }
                    add("span", "note-text", note.text)
                }
            }
        }
    }

    init {
        filter(Query(""))
    }

    /** Shows the notes that [query] finds, and returns their number. */
    fun filter(query: Query): Int {
        var found = 0
        notes.forEachIndexed { i, note ->
            val isFound = query.matches(note.text)
            rows[i].isHidden = !isFound
            if (isFound) found++
        }
        val share = if (found == notes.size) "" else "${countText(found)} of "
        count.showText(share + countText(notes.size, "note"))
        element.isHidden = found == 0
        return if (query.isEmpty) 0 else found
    }
}
