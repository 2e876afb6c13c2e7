package badlog.page.note

import badlog.page.dom.LocalStorage
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.Notebook
import badlog.viewer.choices.note.NotesException
import badlog.viewer.choices.note.notesMergedWith
import badlog.viewer.choices.note.notesOfJson
import badlog.viewer.choices.note.toJson

/**
 * The notes about moments of the recording: those that the page was made with, and those of its reader, which the browser remembers for
 * the file. Other tabs may show the same page.
 *
 * @param given the notes that the page was made with.
 */
internal class PageNotes(fileKey: String, private val given: List<Note>) {
    private val key = "notes:$fileKey"
    private val listeners = ArrayList<() -> Unit>()

    /** The notes as this tab last read or stored them. */
    private var known = remembered()

    /** The notes, and the one that is being written. */
    var now: Notebook = Notebook(known)
        private set

    /** Calls [listener] after each change of the notes. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /** Changes them by [step], and remembers changed notes. */
    fun change(step: Notebook.() -> Notebook) {
        val changed = now.step()
        val isSame = changed.notes == now.notes
        now = if (isSame) changed else changed.with(stored(changed.notes))
        if (!isSame) for (listener in listeners) listener()
    }

    /** Remembers [notes], with what other tabs have changed meanwhile, and returns both. */
    private fun stored(notes: List<Note>): List<Note> {
        val merged = notes.notesMergedWith(remembered(), known)
        // What the page was made with tells another copy of it which of these are the reader's own.
        LocalStorage[key] = given.toJson() + SEPARATOR + merged.toJson()
        // A browser that stores nothing is not another tab that removes them.
        known = remembered()
        return merged
    }

    private fun remembered(): List<Note> {
        val text = LocalStorage[key] ?: return given
        return try {
            notesOfJson(text.substringAfter(SEPARATOR)).notesMergedWith(given, notesOfJson(text.substringBefore(SEPARATOR)))
        } catch (_: NotesException) {
            given
        }
    }

    private companion object {
        /** JSON never contains it. */
        const val SEPARATOR = '\u0000'
    }
}
