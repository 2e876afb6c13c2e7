package badlog.page.note

import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Scene
import badlog.viewer.panel.Rows
import badlog.viewer.panel.notesAbove
import badlog.viewer.shown.search.Query
import org.w3c.dom.HTMLElement

/** The notes about moments of the recording, see [notesAbove]; hidden if there are none. */
internal class NoteList(private val scene: Scene, private val notes: PageNotes) {
    private val nodes = PartNodes(scene.palette, scene.store::send)
    private var query = Query("")

    val element: HTMLElement = element("section", "notes-written findings card") {
        id = "notes"
        setAttribute("aria-label", "Notes")
    }

    init {
        notes.onChange { list() }
        list()
    }

    /** Shows the notes that match [query], and returns their number. */
    fun filter(query: Query): Int {
        this.query = query
        val found = list()
        return if (query.isEmpty) 0 else found
    }

    private fun list(): Int {
        val parts = notesAbove(notes.now.notes, scene.times, query)
        element.patch(nodes.of(parts))
        element.isHidden = parts.isEmpty()
        return (parts.lastOrNull() as Rows?)?.rows?.size ?: 0
    }
}
