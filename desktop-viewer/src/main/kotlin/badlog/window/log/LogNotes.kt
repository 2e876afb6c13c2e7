package badlog.window.log

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.snapshotFlow
import badlog.exporter.NotesFile
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.NoteDraft
import badlog.viewer.choices.note.Notebook
import badlog.viewer.choices.note.marked
import badlog.viewer.choices.note.markedText
import badlog.viewer.choices.note.removedText
import badlog.window.state.StateHolder
import badlog.window.task.FileWrites
import badlog.window.task.NoticeAction
import badlog.window.task.Notices
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.CoroutineStart
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.io.IOException
import java.nio.file.Path

/**
 * The notes of a log, which a file beside it stores.
 *
 * @property log the log; null while none is open, and until its notes are read.
 */
internal data class StoredNotes(val log: Path? = null, val notebook: Notebook = Notebook())

/** The notes of the [current] log. */
internal class LogNotes(
    private val scope: CoroutineScope,
    private val current: CurrentRecording,
    private val notices: Notices,
    private val writes: FileWrites,
) : StateHolder<StoredNotes>(StoredNotes()) {
    private var waiting = 0

    /** The notes, in the order of x. The list does not change while a note is being written. */
    val all: List<Note> by derivedStateOf { state.notebook.notes }

    /** The note that is being written, or changed; null for none. */
    val draft: NoteDraft? get() = state.notebook.draft

    /** Reads the notes of each opened log, until cancelled. */
    suspend fun run() = snapshotFlow { current.recording?.file }.collect { log ->
        change { StoredNotes() }
        if (log == null) return@collect
        val read = withContext(Dispatchers.IO) { NotesFile.read(log) }
        // A person may already be writing a note.
        change { StoredNotes(log, notebook.with(read.notes)) }
        read.problems.forEach(notices::complain)
    }

    /** Begins a note at [x]. */
    fun write(x: Double) = step { begun(x) }

    /** Begins to change [note]. */
    fun rewrite(note: Note) = step { changing(note) }

    /** Sets the text of the note being written. */
    fun type(text: String) = step { typed(text) }

    /** Discards the note being written. */
    fun cancel() = step { cancelled() }

    /** Saves the note being written, if it has text. */
    fun keep() {
        if (draft?.replaced == null) state.notebook.fullness?.let { return notices.complain(it) }
        save { kept() }
    }

    /** Adds a mark at [x], and reports it with its [place] for people. */
    fun mark(x: Double, place: String) {
        state.notebook.fullness?.let { return notices.complain(it) }
        save { marked(x) }
        if (state.log != null) notices.say(markedText(place))
    }

    /** Removes [note], and reports that with its [place] for people, with an action to undo it. */
    fun remove(note: Note, place: String) {
        val log = state.log
        save { without(note) }
        val undo = NoticeAction("Undo") { if (state.log == log) save { restored(note) } }
        if (log != null) notices.say(removedText(place), undo)
    }

    private fun step(step: Notebook.() -> Notebook) = change { copy(notebook = notebook.step()) }

    private fun save(step: Notebook.() -> Notebook) {
        val before = state.notebook
        val changed = before.step()
        if (changed.notes == all) return change { copy(notebook = changed) }
        val log = state.log ?: return notices.complain("The notes of this log are still being read; try again in a moment.")
        change { copy(notebook = changed) }
        waiting++
        scope.launch(start = CoroutineStart.UNDISPATCHED) {
            try {
                val written = writes.write { NotesFile.update(log, changed.notes, before.notes) }
                // The file does not have later changes yet.
                if (waiting == 1 && state.log == log) change { copy(notebook = notebook.with(written.notes)) }
            } catch (e: IOException) {
                // A text that could not be written can still be copied.
                if (state.log == log) change { copy(notebook = if (notebook == changed) before else notebook.with(before.notes)) }
                notices.complain(e.message ?: "The notes could not be written.")
            } finally {
                waiting--
            }
        }
    }
}
