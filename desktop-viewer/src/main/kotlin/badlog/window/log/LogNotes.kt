package badlog.window.log

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import badlog.exporter.NotesFile
import badlog.protocol.Note
import badlog.protocol.NotesException
import badlog.window.state.StateHolder
import badlog.window.task.Notices
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import java.io.IOException
import java.nio.file.Path

/**
 * The notes about moments of the log, in the order of x.
 *
 * @property log the log; null while none is open, and until its notes are read.
 * @property isDamaged whether the log's file of notes could not be read, and so must not be replaced.
 */
internal data class WrittenNotes(val log: Path? = null, val notes: List<Note> = emptyList(), val isDamaged: Boolean = false)

/** The notes of the [current] log, and the file beside it that stores them. */
internal class LogNotes(private val current: CurrentRecording, private val notices: Notices) : StateHolder<WrittenNotes>(WrittenNotes()) {
    /** The note that is being written, or changed; null for none. */
    var draft: NoteDraft? by mutableStateOf(null)
        private set

    /** Reads the notes of each log that is opened; ends with the window. */
    suspend fun run() = snapshotFlow { current.recording?.file }.collect { log ->
        draft = null
        change { WrittenNotes() }
        if (log == null) return@collect
        try {
            val notes = withContext(Dispatchers.IO) { NotesFile.read(log) }
            change { WrittenNotes(log, notes) }
        } catch (e: NotesException) {
            change { WrittenNotes(log, isDamaged = true) }
            notices.complain(e.message.orEmpty())
        }
    }

    /** Begins a note at [x], or an edit of [note]. */
    fun write(x: Double, note: Note? = null) {
        if (state.isDamaged) return notices.complain("The notes of this log cannot be read; repair or delete their file first.")
        draft = NoteDraft(note?.x ?: x, note?.text.orEmpty(), note)
    }

    /** Sets the text of the note being written. */
    fun type(text: String) {
        draft = draft?.copy(text = text.take(Note.MAX_TEXT))
    }

    /** Discards the note being written. */
    fun cancel() {
        draft = null
    }

    /** Saves the note being written, if it has text. */
    fun keep() {
        val written = draft ?: return
        if (written.text.isBlank()) return cancel()
        if (written.replaced == null && state.notes.size >= Note.MAX_NOTES) {
            return notices.complain("This log has ${Note.MAX_NOTES} notes; remove one first.")
        }
        if (save(state.notes - setOfNotNull(written.replaced) + Note(written.x, written.text.trim()))) draft = null
    }

    /** Removes [note]. */
    fun remove(note: Note) {
        save(state.notes - note)
    }

    private fun save(notes: List<Note>): Boolean {
        val log = state.log
        if (log == null) {
            notices.complain("The notes of this log are still being read; try again in a moment.")
            return false
        }
        val sorted = notes.sortedBy { it.x }
        return try {
            NotesFile.write(log, sorted)
            change { copy(notes = sorted) }
            true
        } catch (e: IOException) {
            notices.complain(e.message ?: "The notes could not be written.")
            false
        }
    }
}

/**
 * A note that is being written.
 *
 * @property replaced the note that it changes; null for a new one.
 */
internal data class NoteDraft(val x: Double, val text: String, val replaced: Note?)
