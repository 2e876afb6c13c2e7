package badlog.page.note

import badlog.page.dom.LocalStorage
import badlog.protocol.PageAdditions
import badlog.viewer.choices.note.NoteChange
import badlog.viewer.choices.note.NoteHistory
import badlog.viewer.choices.note.Notebook
import badlog.viewer.choices.note.NotesException
import badlog.viewer.choices.note.noteChangesOf
import badlog.viewer.choices.note.notesOfJson
import badlog.viewer.choices.note.toLines
import kotlin.js.Date

/**
 * The notes about moments of the recording: the page's own, with the reader's changes. The browser remembers the changes for the file.
 * Other tabs may show the same page, or a copy of it.
 *
 * @param given the additions that the page was made with.
 */
internal class PageNotes(fileKey: String, private val given: PageAdditions) {
    private val key = "note-changes:$fileKey"
    private val keyBefore = "notes:$fileKey"
    private val listeners = ArrayList<() -> Unit>()

    /** All changes that this tab knows; more than is stored if the browser stores nothing. */
    var history: NoteHistory = withStored(given.noteChanges)
        private set

    /** The notes, and the draft of a note if there is one. */
    var now: Notebook = Notebook(history.notes)
        private set

    /** Calls [listener] after each change of the notes. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /** Changes the notes by [step], and stores changed notes together with changes of other tabs. */
    fun change(step: Notebook.() -> Notebook) {
        val changed = now.step()
        now = changed
        val before = history.notes
        if (changed.notes == before) return
        val made = history.changesTo(changed.notes, before, author = "", { timeAfter(it, Date.now()) }) {
            "${Date.now()}-${js("Math.random()")}"
        }
        history = withStored(history.changes + made)
        LocalStorage[key] = history.changes.filter { it !in given.noteChanges && !it.id.startsWith(BEFORE) }.toLines()
        now = changed.with(history.notes)
        for (listener in listeners) listener()
    }

    private fun withStored(changes: List<NoteChange>) =
        NoteHistory.of(given.notes, changesBefore() + noteChangesOf(LocalStorage[key].orEmpty()).changes + changes)

    /** Returns the changes to notes that pages of an older badlog stored, as the notes before and after. */
    private fun changesBefore(): List<NoteChange> {
        val text = LocalStorage[keyBefore] ?: return emptyList()
        return try {
            val (before, after) = listOf(text.substringBefore(SEPARATOR), text.substringAfter(SEPARATOR)).map(::notesOfJson)
            val own = NoteHistory.of(given.notes, given.noteChanges)
            // For a copy of such a page, changes of the original page are given notes.
            val known = before + own.notes.filter { note -> note !in before && after.count { it.x == note.x } == 1 }
            var count = 0
            own.changesTo(after, known, author = "", { timeAfter(it, 0.0) }) { "$BEFORE${count++}" }
        } catch (_: NotesException) {
            emptyList()
        }
    }

    private companion object {
        /** A separator that JSON never contains. */
        const val SEPARATOR = '\u0000'

        /** The start of the ids of changes stored by an older badlog, which may still change them. */
        const val BEFORE = "before-"

        /** The last moment of the years with four digits, in ms since 1970. */
        const val LATEST = 253_402_300_799_999.0

        /** Returns the time [now], in ms; or the time after [last] if another computer's clock is ahead. */
        fun timeAfter(last: String?, now: Double): String =
            Date(minOf(LATEST, maxOf(now, if (last == null) now else Date.parse(last) + 1))).toISOString()
    }
}
