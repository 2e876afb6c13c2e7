package badlog.window.log

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.snapshotFlow
import badlog.exporter.NotesFile
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.NoteDraft
import badlog.viewer.choices.note.Notebook
import badlog.viewer.choices.note.NotesException
import badlog.window.state.StateHolder
import badlog.window.task.Notices
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import java.io.IOException
import java.nio.file.Path

/**
 * The notes of a log, and the file beside it that stores them.
 *
 * @property log the log; null while none is open, and until its notes are read.
 * @property stored the notes as they were last in the file.
 * @property isDamaged whether the file could not be read, and so must not be replaced.
 */
internal data class StoredNotes(
    val log: Path? = null,
    val notebook: Notebook = Notebook(),
    val stored: List<Note> = emptyList(),
    val isDamaged: Boolean = false,
)

/** The notes of the [current] log. */
internal class LogNotes(private val current: CurrentRecording, private val notices: Notices) : StateHolder<StoredNotes>(StoredNotes()) {
    /** The notes, in the order of x; observers of this alone do not see how a note is written. */
    val all: List<Note> by derivedStateOf { state.notebook.notes }

    /** The note that is being written, or changed; null for none. */
    val draft: NoteDraft? get() = state.notebook.draft

    /** Reads the notes of each log that is opened; ends with the window. */
    suspend fun run() = snapshotFlow { current.recording?.file }.collect { log ->
        change { StoredNotes() }
        if (log == null) return@collect
        try {
            val notes = withContext(Dispatchers.IO) { NotesFile.read(log) }
            // Somebody may already be writing one.
            change { StoredNotes(log, notebook.with(notes), notes) }
        } catch (e: NotesException) {
            change { StoredNotes(log, isDamaged = true) }
            notices.complain(e.message.orEmpty())
        }
    }

    /** Begins a note at [x]. */
    fun write(x: Double) = begin { begun(x) }

    /** Begins to change [note]. */
    fun rewrite(note: Note) = begin { changing(note) }

    /** Sets the text of the note being written. */
    fun type(text: String) = step { typed(text) }

    /** Discards the note being written. */
    fun cancel() = step { cancelled() }

    /** Saves the note being written, if it has text. */
    fun keep() {
        if (draft?.replaced == null) state.notebook.fullness?.let { return notices.complain(it) }
        save { kept() }
    }

    /** Removes [note]. */
    fun remove(note: Note) = save { without(note) }

    private fun begin(step: Notebook.() -> Notebook) {
        if (state.isDamaged) return notices.complain("The notes of this log cannot be read; repair or delete their file first.")
        step(step)
    }

    private fun step(step: Notebook.() -> Notebook) = change { copy(notebook = notebook.step()) }

    private fun save(step: Notebook.() -> Notebook) {
        val changed = state.notebook.step()
        if (changed.notes == all) return change { copy(notebook = changed) }
        val log = state.log ?: return notices.complain("The notes of this log are still being read; try again in a moment.")
        try {
            val notes = NotesFile.update(log, changed.notes, state.stored)
            change { copy(notebook = changed.with(notes), stored = notes) }
        } catch (e: IOException) {
            notices.complain(e.message ?: "The notes could not be written.")
        } catch (e: NotesException) {
            notices.complain(e.message.orEmpty())
        }
    }
}
