package badlog.window.todo

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
import androidx.compose.runtime.mutableStateListOf
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.todo.NextMatch
import badlog.viewer.todo.OwnTask
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.UNNAMED_MATCH
import badlog.viewer.todo.matchText
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import badlog.window.theme.fieldFrame
import badlog.window.theme.sheet

/** The dialog [sheet] about the list; shown above the window. */
@Composable
internal fun TodoDialog(todo: FolderTodo, sheet: TodoSheet, modifier: Modifier) {
    val next = todo.state.list.next
    val last = todo.state.list.lastMatch
    when (sheet) {
        is TodoSheet.Done -> FieldSheet(
            sheet,
            "Mark as done: ${sheet.item.title}",
            listOf(DialogField("What was done"), DialogField("Before which match", next), DialogField("By whom", todo.author)),
            "Mark as done",
            { todo.ask(null) },
            modifier,
        ) { (what, before, by) ->
            todo.rememberAuthor(by)
            todo.write(sheet.item.task, TodoDeed.Done(what, matchText(before, last).ifEmpty { null }), by.ifEmpty { todo.author })
        }

        is TodoSheet.Assign -> FieldSheet(
            sheet,
            "Assign: ${sheet.item.title}",
            listOf(DialogField("Who takes it on; nobody if empty", sheet.item.person)),
            "Assign",
            { todo.ask(null) },
            modifier,
        ) { (person) -> todo.write(sheet.item.task, TodoDeed.Assign(person)) }

        TodoSheet.New -> FieldSheet(
            sheet,
            "New item",
            listOf(DialogField("What is to be done", isNeeded = true), DialogField("Who takes it on; nobody if empty")),
            "Add",
            { todo.ask(null) },
            modifier,
        ) { (text, person) ->
            val task = OwnTask(text)
            todo.write(task, TodoDeed.Open)
            if (person.isNotEmpty()) todo.write(task, TodoDeed.Assign(person))
        }

        TodoSheet.Next -> FieldSheet(
            sheet,
            "Set the next match",
            listOf(
                DialogField(
                    "Next match, such as Qualification 61 or q61",
                    next.takeIf {
                        !it.startsWith("the ") && it != UNNAMED_MATCH
                    }.orEmpty(),
                    true,
                ),
            ),
            "Set",
            { todo.ask(null) },
            modifier,
        ) { (match) -> todo.write(NextMatch(matchText(match, last)), TodoDeed.Open) }
    }
}

/** A field of a dialog: its label, and its initial answer. */
private class DialogField(val label: String, val answer: String = "", val isNeeded: Boolean = false)

/**
 * The dialog [sheet] with [fields]; the first one has the keyboard focus. Enter in a field and the button [label] call [onAnswer] with the
 * answers, and close the dialog; Escape only closes it.
 */
@Composable
private fun FieldSheet(
    sheet: TodoSheet,
    title: String,
    fields: List<DialogField>,
    label: String,
    onClose: () -> Unit,
    modifier: Modifier,
    onAnswer: (List<String>) -> Unit,
) {
    val answers = remember(sheet) { mutableStateListOf(*fields.map { it.answer }.toTypedArray()) }
    val focus = remember { FocusRequester() }
    fun isReady() = fields.indices.none { fields[it].isNeeded && answers[it].isBlank() }
    fun answer() {
        if (!isReady()) return
        onClose()
        onAnswer(answers.map { it.trim() })
    }
    LaunchedEffect(sheet) { focus.requestFocus() }
    Column(
        modifier
            .sheet("To do sheet", widest = 520.dp)
            .onPreviewKeyEvent {
                val isEscape = it.type == KeyEventType.KeyDown && it.key == Key.Escape
                if (isEscape) onClose()
                isEscape
            }
            .padding(start = 20.dp, end = 12.dp, top = 8.dp, bottom = 12.dp),
        Arrangement.spacedBy(6.dp),
    ) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            Text(
                title,
                Modifier.weight(1f),
                fontSize = 16.sp,
                fontWeight = FontWeight.SemiBold,
                maxLines = 2,
                overflow = TextOverflow.Ellipsis,
            )
            ToolButton("Close the sheet (Escape)", Icons.Close, onClick = onClose)
        }
        fields.forEachIndexed { i, field ->
            Text(field.label, color = LocalPalette.current.muted, fontSize = 12.sp)
            val entered = Modifier.onPreviewKeyEvent {
                val isEnter = it.type == KeyEventType.KeyDown && (it.key == Key.Enter || it.key == Key.NumPadEnter)
                if (isEnter) answer()
                isEnter
            }
            AnswerField(answers[i], field.label, if (i == 0) entered.focusRequester(focus) else entered) {
                answers[i] = it.take(TodoChange.MAX_TEXT)
            }
        }
        Row(Modifier.fillMaxWidth().padding(top = 4.dp), Arrangement.spacedBy(8.dp, Alignment.End)) {
            ToolButton("Cancel (Escape)", text = "Cancel", onClick = onClose)
            ToolButton("$label (Enter)", text = label, isOn = isReady(), isEnabled = isReady(), onClick = ::answer)
        }
    }
}

@Composable
private fun AnswerField(text: String, label: String, modifier: Modifier, onChange: (String) -> Unit) {
    val palette = LocalPalette.current
    val interactions = remember { MutableInteractionSource() }
    BasicTextField(
        text,
        onChange,
        modifier
            .fillMaxWidth()
            .fieldFrame(interactions, horizontal = 10.dp, vertical = 8.dp)
            .semantics { contentDescription = label },
        textStyle = LocalTextStyle.current.copy(color = palette.text),
        singleLine = true,
        interactionSource = interactions,
        cursorBrush = SolidColor(palette.accent),
    )
}
