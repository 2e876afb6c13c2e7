package badlog.window.theme

import androidx.compose.foundation.ExperimentalFoundationApi
import androidx.compose.foundation.TooltipArea
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.gestures.detectTapGestures
import androidx.compose.foundation.gestures.draggable
import androidx.compose.foundation.gestures.rememberDraggableState
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.InteractionSource
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsFocusedAsState
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.material3.Icon
import androidx.compose.material3.LocalTextStyle
import androidx.compose.material3.Text
import androidx.compose.material3.VerticalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.draw.shadow
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.graphics.vector.ImageVector
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.password
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.toggleableState
import androidx.compose.ui.state.ToggleableState
import androidx.compose.ui.text.TextRange
import androidx.compose.ui.text.input.PasswordVisualTransformation
import androidx.compose.ui.text.input.TextFieldValue
import androidx.compose.ui.text.input.VisualTransformation
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import java.awt.Cursor

/**
 * A small button with an icon, a text, or both.
 *
 * @param description its effect: its tooltip, and its name for screen readers and tests.
 * @param text its text; null for the icon only.
 * @param color the color of its icon and text while it is neither on nor disabled.
 * @param isOn whether it represents something that is on.
 */
@Composable
internal fun ToolButton(
    description: String,
    icon: ImageVector? = null,
    text: String? = null,
    isOn: Boolean? = null,
    isEnabled: Boolean = true,
    color: Color = LocalPalette.current.text,
    modifier: Modifier = Modifier,
    onClick: () -> Unit,
) {
    val palette = LocalPalette.current
    val interactions = remember { MutableInteractionSource() }
    val isHovered by interactions.collectIsHoveredAsState()
    val tint = when {
        !isEnabled -> palette.muted.copy(alpha = 0.5f)
        isOn == true -> palette.accent
        else -> color
    }
    val background = when {
        isOn == true -> palette.accentSoft
        isHovered && isEnabled -> palette.raised
        else -> Color.Transparent
    }
    Tip(description) {
        Row(
            modifier
                .clip(RoundedCornerShape(5.dp))
                .background(background)
                .hoverable(interactions)
                .clickable(enabled = isEnabled, role = Role.Button, onClick = onClick)
                .semantics {
                    contentDescription = description
                    if (isOn != null) toggleableState = ToggleableState(isOn)
                }
                .padding(6.dp),
            horizontalArrangement = Arrangement.spacedBy(6.dp),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            if (icon != null) Icon(icon, contentDescription = null, Modifier.size(16.dp), tint)
            if (text != null) Text(text, color = tint, maxLines = 1)
        }
    }
}

/** Shows [text] as a tooltip when the pointer rests on [content]; an empty text has none. */
@Composable
internal fun Tip(text: String, modifier: Modifier = Modifier, content: @Composable () -> Unit) = Tip({ text }, modifier, content)

/** Shows a tooltip in the same way, with a text that is computed only when it is shown. */
@OptIn(ExperimentalFoundationApi::class)
@Composable
internal fun Tip(text: () -> String, modifier: Modifier = Modifier, content: @Composable () -> Unit) {
    TooltipArea(
        tooltip = {
            val palette = LocalPalette.current
            val shown = remember(text) { text() }
            if (shown.isEmpty()) return@TooltipArea
            Text(
                shown,
                Modifier
                    .widthIn(max = 420.dp)
                    .border(1.dp, palette.border, RoundedCornerShape(4.dp))
                    .background(palette.raised, RoundedCornerShape(4.dp))
                    .padding(horizontal = 8.dp, vertical = 4.dp),
                fontSize = 12.sp,
            )
        },
        modifier = modifier,
        content = content,
    )
}

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

/**
 * Draws the frame around a text field with these [interactions]. It shows whether the field has the keyboard focus, and whether its text
 * [isWrong].
 */
@Composable
internal fun Modifier.fieldFrame(interactions: InteractionSource, horizontal: Dp, vertical: Dp, isWrong: Boolean = false): Modifier {
    val palette = LocalPalette.current
    val isFocused by interactions.collectIsFocusedAsState()
    val color = when {
        isWrong -> palette.error
        isFocused -> palette.accent
        else -> palette.border
    }
    return background(palette.raised, SHAPE).border(if (isFocused) 2.dp else 1.dp, color, SHAPE).padding(horizontal, vertical)
}

private val SHAPE = RoundedCornerShape(5.dp)

/**
 * The line between two parts of the window, which a person can drag.
 *
 * @param onDrag receives the distance of a drag to the right, in dp.
 * @param onReset is called for a double click.
 */
@Composable
internal fun PaneDivider(description: String, onDrag: (Float) -> Unit, onReset: () -> Unit) {
    val palette = LocalPalette.current
    val density = LocalDensity.current.density
    val drag by rememberUpdatedState(onDrag)
    val reset by rememberUpdatedState(onReset)
    val interactions = remember { MutableInteractionSource() }
    val isHovered by interactions.collectIsHoveredAsState()
    Box(
        Modifier
            .width(5.dp)
            .fillMaxHeight()
            .hoverable(interactions)
            .pointerHoverIcon(PointerIcon(Cursor(Cursor.E_RESIZE_CURSOR)))
            .pointerInput(Unit) { detectTapGestures(onDoubleTap = { reset() }) }
            .draggable(rememberDraggableState { drag(it / density) }, Orientation.Horizontal)
            .semantics { contentDescription = description },
        contentAlignment = Alignment.Center,
    ) {
        VerticalDivider(thickness = if (isHovered) 3.dp else 1.dp, color = if (isHovered) palette.accent else palette.border)
    }
}

/** Makes an element a sheet above the window with the title [name], at most [widest] wide. */
@Composable
internal fun Modifier.sheet(name: String, widest: Dp): Modifier {
    val palette = LocalPalette.current
    val shape = RoundedCornerShape(8.dp)
    return padding(16.dp)
        .widthIn(max = widest)
        .shadow(12.dp, shape)
        .background(palette.surface, shape)
        .border(1.dp, palette.border, shape)
        .semantics { contentDescription = name }
}

/** Makes an element a small label over graphs, with a border of this [color]. */
@Composable
internal fun Modifier.labelFrame(color: Color): Modifier = this
    .border(1.dp, color, LABEL_SHAPE)
    .background(LocalPalette.current.raised, LABEL_SHAPE)
    .padding(horizontal = 8.dp, vertical = 3.dp)

private val LABEL_SHAPE = RoundedCornerShape(4.dp)
