package badlog.page.note

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.view.Scene
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.Notebook
import badlog.viewer.input.Action
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLTextAreaElement
import org.w3c.dom.events.KeyboardEvent

/** The dialog in which a person writes and changes [notes], and the button that opens it. */
internal class NoteDialog(private val scene: Scene, private val notes: PageNotes) {
    private lateinit var heading: HTMLElement
    private lateinit var text: HTMLTextAreaElement

    val button: HTMLElement = element("div", "formula-button") {
        addButton("", "", "${Action.NEW_NOTE.meaning} (${Action.NEW_NOTE.shortcut})") { write(scene.place.now.ofNote) }.apply {
            id = "add-note"
            setAttribute("aria-label", "Write a note")
            appendChild(Icon.NOTE.draw())
            add("span", "", "Note")
        }
    }

    val element: HTMLElement = element("dialog", "help note-dialog") {
        id = "note-dialog"
        setAttribute("aria-labelledby", "note-title")
        add("div", "help-head") {
            heading = add("h2") { id = "note-title" }
            addIconButton("", Icon.CLOSE, "Close") { close() }
        }
        add("div", "formula-body") {
            text = add("textarea", "note-entry").unsafeCast<HTMLTextAreaElement>()
            add("div", "note-actions") {
                addButton("", "Save note", "Save the note (Enter)") { save() }.id = "save-note"
            }
        }
        addEventListener("click", { if (it.target == this) close() })
        // By the browser's own Escape, too.
        addEventListener("close", { notes.change { cancelled() } })
    }

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

    /** Begins a note at [x]. */
    fun write(x: Double) = open { begun(x) }

    /** Begins to change [note]. */
    fun edit(note: Note) = open { changing(note) }

    private fun open(begin: Notebook.() -> Notebook) {
        if (element.hasAttribute("open")) return
        notes.change(begin)
        val draft = notes.now.draft ?: return
        if (draft.replaced == null) notes.now.fullness?.let { return scene.notice.say(it) }
        heading.textContent = "Note at ${scene.xText(draft.x)}"
        text.value = draft.text
        element.asDynamic().showModal()
        text.focus()
    }

    private fun save() {
        notes.change { typed(text.value).kept() }
        close()
    }

    private fun close() {
        element.asDynamic().close()
    }
}
