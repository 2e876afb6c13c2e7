package badlog.page.note

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.removedText
import badlog.viewer.shown.search.Query
import badlog.viewer.text.countOf
import badlog.viewer.text.decimalsFor
import badlog.viewer.text.fixedText
import org.w3c.dom.HTMLElement

/**
 * The notes about moments of the recording, each with a link to its moment; hidden if there are none.
 *
 * @param onEdit called with a note to change.
 */
internal class NoteList(private val scene: Scene, private val notes: PageNotes, private val onEdit: (Note) -> Unit) {
    private val decimals = decimalsFor(scene.range.full.width)
    private lateinit var count: HTMLElement
    private lateinit var rows: HTMLElement
    private var query = Query("")

    val element: HTMLElement = element("section", "notes-written findings card") {
        id = "notes"
        setAttribute("aria-label", "Notes")
        add("header", "graph-head") {
            add("h2", "findings-title", "Notes")
            count = add("span", "unit")
        }
        rows = add("ul", "note-rows")
    }

    init {
        notes.onChange(::list)
        list()
    }

    /** Shows the notes that match [query], and returns their number. */
    fun filter(query: Query): Int {
        this.query = query
        val found = list()
        return if (query.isEmpty) 0 else found
    }

    private fun list(): Int {
        val all = notes.now.notes
        val found = all.filter { query.matches(it.text) }
        rows.textContent = ""
        for (note in found) rows.appendChild(row(note))
        count.showText(countOf(found.size, all.size, "note"))
        element.isHidden = found.isEmpty()
        return found.size
    }

    private fun row(note: Note) = element("li", "note-row") {
        val moment = fixedText(note.x, decimals)
        addButton("event-go", moment, "Zoom to it") { scene.zoomTo(note.x) }
        add("span", "note-text", note.text)
        add("span", "note-tools") {
            addIconButton("", Icon.NOTE, "Change the note at $moment") { onEdit(note) }
            addIconButton("", Icon.CLOSE, "Remove the note at $moment") { remove(note, moment) }
        }
    }

    private fun remove(note: Note, moment: String) {
        notes.change { without(note) }
        scene.notice.offer(removedText(moment), "Undo") { notes.change { restored(note) } }
    }
}
