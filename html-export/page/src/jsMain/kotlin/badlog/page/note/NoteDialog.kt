package badlog.page.note

import badlog.page.dom.Dialog
import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Scene
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.Notebook
import badlog.viewer.choices.note.marked
import badlog.viewer.choices.note.markedText
import badlog.viewer.choices.note.removedText
import badlog.viewer.input.KeyAction
import badlog.viewer.panel.Rows
import badlog.viewer.panel.notesAbove
import badlog.viewer.shown.search.Query
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLTextAreaElement
import org.w3c.dom.events.KeyboardEvent

/** The dialog that writes and changes [notes], and the button that opens it; also adds marks, and removes notes. */
internal class NoteDialog(private val scene: Scene, private val notes: PageNotes) {
    private lateinit var text: HTMLTextAreaElement

    val button: HTMLElement = element("div", "formula-button") {
        addButton("", "", "${KeyAction.NEW_NOTE.meaning} (${KeyAction.NEW_NOTE.shortcut})") { write(scene.store.place.ofNote) }.apply {
            id = "add-note"
            setAttribute("aria-label", "Write a note")
            appendChild(Icon.NOTE.draw())
            add("span", "", "Note")
        }
    }

    private val dialog = Dialog("note-dialog", "note-dialog") {
        add("div", "formula-body") {
            text = add("textarea", "note-entry").unsafeCast<HTMLTextAreaElement>()
            add("div", "note-actions") {
                addButton("", "Save note", "Save the note (Enter)") { save() }.id = "save-note"
            }
        }
        // The browser's own Escape key closes the dialog, too.
        addEventListener("close", { notes.change { cancelled() } })
    }

    val element: HTMLElement = dialog.element

    init {
        text.rows = 3
        text.maxLength = Note.MAX_TEXT
        text.setAttribute("aria-label", "Text of the note")
        text.addEventListener("keydown", { event ->
            val key = event.unsafeCast<KeyboardEvent>()
            if (key.key == "Enter" && !key.shiftKey && !key.isComposing) {
                event.preventDefault()
                save()
            }
        })
    }

    /** Opens the dialog for a new note at [x]. */
    fun write(x: Double) = open { begun(x) }

    /** Adds a mark at [x]. */
    fun mark(x: Double) {
        notes.now.fullness?.let { return scene.notice.say(it) }
        notes.change { marked(x) }
        scene.notice.say(markedText(scene.xText(x)))
    }

    /** Opens the dialog for changing [note]. */
    fun edit(note: Note) = open { changing(note) }

    /** Removes [note], and offers to restore it. */
    fun remove(note: Note) {
        notes.change { without(note) }
        scene.notice.offer(removedText(scene.xText(note.x)), "Undo") { notes.change { restored(note) } }
    }

    private fun open(begin: Notebook.() -> Notebook) {
        if (dialog.isOpen) return
        notes.change(begin)
        val draft = notes.now.draft ?: return
        if (draft.replaced == null) notes.now.fullness?.let { return scene.notice.say(it) }
        dialog.title = "Note at ${scene.xText(draft.x)}"
        text.value = draft.text
        dialog.open()
        text.focus()
    }

    private fun save() {
        notes.change { typed(text.value).kept() }
        dialog.close()
    }
}

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
