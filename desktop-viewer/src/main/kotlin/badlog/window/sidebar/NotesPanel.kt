package badlog.window.sidebar

import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.material3.LocalTextStyle
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.NoteDraft
import badlog.viewer.panel.LogTimes
import badlog.viewer.state.PlaceAction
import badlog.viewer.todo.NoteTask
import badlog.window.log.AxisView
import badlog.window.log.LogNotes
import badlog.window.log.OpenRecording
import badlog.window.panel.inspectorLine
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import badlog.window.theme.fieldFrame
import badlog.window.todo.FolderTodo
import badlog.window.todo.TodoButtons
import badlog.window.todo.TodoMark

/** The notes of [open] and the field for writing one. A click on a note goes to its moment and calls [onGo]. */
@Composable
internal fun NotesPanel(notes: LogNotes, todo: FolderTodo, view: AxisView, open: OpenRecording, onGo: () -> Unit, modifier: Modifier) {
    val times = open.times
    Column(modifier) {
        val draft = notes.draft
        if (draft == null) {
            ToolButton("Write a note at the cursor (M)", text = "Write a note") {
                notes.write(view.place.ofNote)
            }
        } else {
            NoteField(notes, draft, times)
        }
        if (notes.all.isEmpty()) {
            PanelHint("Notes are kept beside the log, in ${open.file.fileName}.notes-….jsonl, and exported with its page.")
        }
        LazyColumn {
            items(notes.all) { note ->
                val task = NoteTask(open.file.fileName.toString(), note.x + 0.0, note.text)
                NoteLine(notes, note, times, todo, task) {
                    view.send(PlaceAction.GoTo(note.x))
                    onGo()
                }
            }
        }
    }
}

@Composable
private fun NoteField(notes: LogNotes, draft: NoteDraft, times: LogTimes) {
    val palette = LocalPalette.current
    val focus = remember { FocusRequester() }
    val interactions = remember { MutableInteractionSource() }
    LaunchedEffect(draft.x, draft.replaced) { focus.requestFocus() }
    Column(Modifier.fillMaxWidth().padding(8.dp), Arrangement.spacedBy(4.dp)) {
        Text("Note at ${times.logged(draft.x)}", color = palette.muted)
        BasicTextField(
            draft.text,
            notes::type,
            Modifier
                .fillMaxWidth()
                .fieldFrame(interactions, horizontal = 8.dp, vertical = 6.dp)
                .focusRequester(focus)
                .onPreviewKeyEvent { handles(it, notes) }
                .semantics { contentDescription = "Text of the note" },
            textStyle = LocalTextStyle.current.copy(color = palette.text),
            maxLines = 6,
            interactionSource = interactions,
            cursorBrush = SolidColor(palette.accent),
        )
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp, Alignment.End)) {
            ToolButton("Cancel the note (Escape)", text = "Cancel", onClick = notes::cancel)
            ToolButton("Save the note (Enter)", text = "OK", isOn = true, isEnabled = draft.text.isNotBlank(), onClick = notes::keep)
        }
    }
}

/** Handles keys: Enter saves, Escape cancels; Shift+Enter is a new line. */
private fun handles(event: KeyEvent, notes: LogNotes): Boolean {
    if (event.type != KeyEventType.KeyDown) return false
    when {
        event.key == Key.Escape -> notes.cancel()
        (event.key == Key.Enter || event.key == Key.NumPadEnter) && !event.isShiftPressed -> notes.keep()
        else -> return false
    }
    return true
}

@Composable
private fun NoteLine(notes: LogNotes, note: Note, times: LogTimes, todo: FolderTodo, task: NoteTask, onClick: () -> Unit) {
    Column(Modifier.inspectorLine("Note: ${note.text}", isSelected = false, gap = 4.dp, onClick)) {
        Row(Modifier.fillMaxWidth(), verticalAlignment = Alignment.CenterVertically) {
            Text(times.logged(note.x), Modifier.weight(1f), color = LocalPalette.current.muted)
            ToolButton("Change the note at ${times.logged(note.x)}", text = "Change") { notes.rewrite(note) }
            ToolButton("Remove the note at ${times.logged(note.x)}", text = "Remove") { notes.remove(note, times.logged(note.x)) }
        }
        Text(note.text)
        TodoMark(todo, task)
        TodoButtons(todo, task)
    }
}
