package badlog.window.sidebar

import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
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
import badlog.viewer.choices.note.NoteDraft
import badlog.viewer.panel.ListedTasks
import badlog.viewer.panel.LogTimes
import badlog.viewer.panel.notesPanel
import badlog.viewer.state.Action
import badlog.window.log.LogNotes
import badlog.window.log.OpenRecording
import badlog.window.panel.PanelView
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import badlog.window.theme.fieldFrame
import badlog.window.todo.FolderTodo

/** The notes of [open], see [notesPanel], and the field for writing one. */
@Composable
internal fun NotesPanel(notes: LogNotes, todo: FolderTodo, open: OpenRecording, send: (Action) -> Unit, modifier: Modifier) {
    Column(modifier) {
        val draft = notes.draft
        if (draft != null) NoteField(notes, draft, open.times)
        val list = todo.state.list.takeIf { todo.state.folder != null }
        val parts = remember(open, notes.all, list, draft == null) {
            val file = open.file.fileName.toString()
            notesPanel(notes.all, open.times, file, list?.let { ListedTasks(it, file, todo.author) }, isWriting = draft != null)
        }
        PanelView(parts, goal = null, send, Modifier.weight(1f))
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
