package badlog.window.theme

import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.material3.Icon
import androidx.compose.material3.LocalTextStyle
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.graphics.vector.ImageVector
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.password
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextRange
import androidx.compose.ui.text.input.PasswordVisualTransformation
import androidx.compose.ui.text.input.TextFieldValue
import androidx.compose.ui.text.input.VisualTransformation
import androidx.compose.ui.unit.dp

/**
 * A single-line field, for searching unless another [icon] shows its purpose; it shows [hint] while it is empty. Escape clears it, unless
 * it [keepsText], and releases the keyboard focus.
 *
 * @param isSecret whether the text is hidden.
 * @param keepsText whether the text is kept, unlike a search.
 * @param isSelectedAtFirst whether the first typed letters replace the text.
 */
@Composable
internal fun SearchField(
    text: String,
    hint: String,
    modifier: Modifier = Modifier,
    icon: ImageVector = Icons.Search,
    isSecret: Boolean = false,
    keepsText: Boolean = false,
    isSelectedAtFirst: Boolean = false,
    onChange: (String) -> Unit,
) {
    val palette = LocalPalette.current
    val focus = LocalFocusManager.current
    val interactions = remember { MutableInteractionSource() }
    var edited by remember { mutableStateOf(TextFieldValue(text, TextRange(0, if (isSelectedAtFirst) text.length else 0))) }
    // The whole area is the field. A click beside the text must give it the keyboard focus; otherwise typing would run commands.
    BasicTextField(
        edited.copy(text = text),
        { typed ->
            val isChanged = typed.text != edited.text || typed.text != text
            edited = typed
            if (isChanged) onChange(typed.text)
        },
        modifier
            .onPreviewKeyEvent {
                val leaves = it.type == KeyEventType.KeyDown && it.key == Key.Escape
                if (leaves) {
                    if (!keepsText) onChange("")
                    focus.clearFocus()
                }
                leaves
            }
            .semantics {
                contentDescription = hint
                if (isSecret) password()
            },
        textStyle = LocalTextStyle.current,
        singleLine = true,
        interactionSource = interactions,
        visualTransformation = if (isSecret) PasswordVisualTransformation() else VisualTransformation.None,
        cursorBrush = SolidColor(palette.accent),
    ) { field ->
        Row(
            Modifier
                .fillMaxWidth()
                .fieldFrame(interactions, horizontal = 8.dp, vertical = 5.dp),
            horizontalArrangement = Arrangement.spacedBy(6.dp),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            Icon(icon, contentDescription = null, Modifier.size(14.dp), palette.muted)
            Box(Modifier.weight(1f)) {
                if (text.isEmpty()) Text(hint, color = palette.muted, maxLines = 1)
                field()
            }
        }
    }
}

/**
 * Moves the keyboard focus to a field when a person [hasAsked] for it, and then calls [onMoved]. The field may have been invisible until
 * then.
 */
@Composable
internal fun rememberAskedFocus(hasAsked: Boolean, onMoved: () -> Unit): FocusRequester {
    val focus = remember { FocusRequester() }
    LaunchedEffect(hasAsked) {
        if (!hasAsked) return@LaunchedEffect
        focus.requestFocus()
        onMoved()
    }
    return focus
}
