package badlog.viewer.panel

import badlog.viewer.choices.note.Note
import badlog.viewer.input.KeyAction
import badlog.viewer.shown.search.Query
import badlog.viewer.state.Action
import badlog.viewer.state.PlaceAction
import badlog.viewer.state.Request
import badlog.viewer.text.countOf

/** Returns the [notes] of a log that [query] matches, for a place above graphs; empty if there are none. [times] formats their times. */
fun notesAbove(notes: List<Note>, times: LogTimes, query: Query): List<Part> {
    val found = notes.filter { query.matches(it.text) }
    if (found.isEmpty()) return emptyList()
    return listOf(Heading(TITLE, countOf(found.size, notes.size, "note")), rows(found, times))
}

/**
 * Returns the [notes] of a log for a panel of their own.
 *
 * @param log the name of the log's file, beside which notes are kept.
 * @param todo the team's list; null if there is none.
 * @param isWriting whether a note is being written, which another one would replace.
 */
fun notesPanel(notes: List<Note>, times: LogTimes, log: String, todo: TodoOfLog?, isWriting: Boolean): List<Part> {
    val kept = "Notes are kept beside the log, in $log.notes-….jsonl, and exported with its page."
    val write =
        Button("Write a note", Action.Press(KeyAction.NEW_NOTE), hint = "Write a note at the cursor (${KeyAction.NEW_NOTE.shortcut})")
    return listOfNotNull(
        if (isWriting) null else Buttons("write", listOf(write)),
        if (notes.isEmpty()) Paragraph("kept", kept, Tone.MUTED) else rows(notes, times, todo),
    )
}

private fun rows(notes: List<Note>, times: LogTimes, todo: TodoOfLog? = null) =
    Rows("note-rows", TITLE, notes.mapIndexed { i, note -> row(i, note, times.logged(note.x), todo?.partsOf(note).orEmpty()) })

private fun row(index: Int, note: Note, moment: String, below: List<Part>): Row {
    val go = PlaceAction.GoTo(note.x, isWithSurroundings = true)
    return Row(
        "note-row $index",
        severity = null,
        "Note: ${note.text}",
        title = "",
        listOf(Line(note.text, moment, open = go, hint = "Zoom to it")),
        open = go,
        tools = listOf(
            Button("Change the note at $moment", Action.Ask(Request.ChangeNote(note)), PartIcon.NOTE),
            Button("Remove the note at $moment", Action.Ask(Request.RemoveNote(note)), PartIcon.CLOSE),
        ),
        below = below,
    )
}

private const val TITLE = "Notes"
