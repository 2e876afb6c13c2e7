package badlog.window.panel

import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.material3.LocalTextStyle
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateListOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.panel.Field
import badlog.viewer.shown.search.Query
import badlog.viewer.state.Action
import badlog.viewer.state.Form
import badlog.window.menu.MenuBox
import badlog.window.menu.MenuLine
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton
import badlog.window.theme.fieldFrame
import badlog.window.theme.sheet

/** Shows [field] as a search field, as a button that opens its suggestions, or as a text that a person types. */
@Composable
internal fun FieldView(field: Field, send: (Action) -> Unit) {
    if (field.isSearch) {
        SearchField(field.text, field.label, Modifier.fillMaxWidth().padding(horizontal = 8.dp, vertical = 4.dp)) { send(field.onText(it)) }
        return
    }
    if (field.suggestions.isEmpty()) return TypedField(field, send)
    var isOpen by remember { mutableStateOf(false) }
    val suggestions = @Composable {
        Suggestions(field.suggestions) { chosen ->
            isOpen = false
            send(field.onText(chosen))
        }
    }
    MenuBox(isOpen, { isOpen = false }, Modifier.padding(start = 22.dp), menu = suggestions) {
        ToolButton(field.hint, text = "${field.label} …") { isOpen = true }
    }
}

/** A field for a short text, which has an effect when a person presses Enter or leaves the field. */
@Composable
private fun TypedField(field: Field, send: (Action) -> Unit) {
    val interactions = remember { MutableInteractionSource() }
    // The text being typed; null while nothing is being typed.
    var draft by remember(field.text) { mutableStateOf<String?>(null) }
    val finish = {
        draft?.takeIf(field.isValid)?.let { send(field.onText(it)) }
        draft = null
    }
    BasicTextField(
        draft ?: field.text,
        { draft = it },
        Modifier
            .width(88.dp)
            .fieldFrame(interactions, horizontal = 5.dp, vertical = 3.dp, isWrong = draft?.let(field.isValid) == false)
            .onFocusChanged { if (!it.isFocused) finish() }
            .onKeyEvent { event ->
                val isEnter = event.type == KeyEventType.KeyDown && (event.key == Key.Enter || event.key == Key.NumPadEnter)
                if (isEnter) finish()
                isEnter
            }
            .semantics { contentDescription = field.label },
        textStyle = LocalTextStyle.current.copy(textAlign = TextAlign.End),
        singleLine = true,
        interactionSource = interactions,
        cursorBrush = SolidColor(LocalPalette.current.accent),
    )
}

@Composable
private fun Suggestions(names: List<String>, onChosen: (String) -> Unit) {
    var filter by remember { mutableStateOf("") }
    val shown = remember(names, filter) { names.filter(Query(filter)::matches) }
    // A menu measures its content before it knows its size, which a lazy list needs to know.
    Column(Modifier.width(280.dp).padding(horizontal = 8.dp)) {
        SearchField(filter, "Search topics") { filter = it }
        LazyColumn(Modifier.width(264.dp).height(240.dp)) {
            items(shown) { name -> MenuLine(name) { onChosen(name) } }
        }
    }
}

/**
 * Shows [form] above the window; its first field has the keyboard focus. Enter in a field and its button confirm it, Escape closes it.
 *
 * @param onClose called when it is closed, before its actions.
 */
@Composable
internal fun FormSheet(form: Form, send: (Action) -> Unit, modifier: Modifier, onClose: () -> Unit) {
    val answers = remember(form) { mutableStateListOf(*form.fields.map { it.text }.toTypedArray()) }
    val focus = remember { FocusRequester() }
    fun answer() {
        if (!form.isReady(answers)) return
        onClose()
        form.actions(answers).forEach(send)
    }
    LaunchedEffect(form) { focus.requestFocus() }
    Column(
        modifier
            .sheet("${form.title} sheet", widest = 520.dp)
            .onKey(Key.Escape, onClose)
            .padding(start = 20.dp, end = 12.dp, top = 8.dp, bottom = 12.dp),
        Arrangement.spacedBy(6.dp),
    ) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            Text(
                form.title,
                Modifier.weight(1f),
                fontSize = 16.sp,
                fontWeight = FontWeight.SemiBold,
                maxLines = 2,
                overflow = TextOverflow.Ellipsis,
            )
            ToolButton("Close the sheet (Escape)", Icons.Close, onClick = onClose)
        }
        form.fields.forEachIndexed { i, field ->
            Text(field.label, color = LocalPalette.current.muted, fontSize = 12.sp)
            val entered = Modifier.onKey(Key.Enter, ::answer).onKey(Key.NumPadEnter, ::answer)
            AnswerField(answers[i], field.label, if (i == 0) entered.focusRequester(focus) else entered) {
                answers[i] = it.take(Form.MAX_TEXT)
            }
            val typed = answers[i].takeIf { it != field.text }.orEmpty()
            for (each in field.suggestions.filter { it.contains(typed, ignoreCase = true) && it != typed }.take(MAX_OFFERED)) {
                MenuLine(each) {
                    answers[i] = each
                    if (form.fields.size == 1) answer()
                }
            }
        }
        Row(Modifier.fillMaxWidth().padding(top = 4.dp), Arrangement.spacedBy(8.dp, Alignment.End)) {
            val isReady = form.isReady(answers)
            ToolButton("Cancel (Escape)", text = "Cancel", onClick = onClose)
            ToolButton("${form.label} (Enter)", text = form.label, isOn = isReady, isEnabled = isReady, onClick = ::answer)
        }
    }
}

private fun Modifier.onKey(key: Key, press: () -> Unit) = onPreviewKeyEvent {
    val isPressed = it.type == KeyEventType.KeyDown && it.key == key
    if (isPressed) press()
    isPressed
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

/** The maximum number of suggestions below a field. */
private const val MAX_OFFERED = 12
