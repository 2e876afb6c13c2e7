package badlog.window.theme

import androidx.compose.foundation.ExperimentalFoundationApi
import androidx.compose.foundation.TooltipArea
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.vector.ImageVector
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.toggleableState
import androidx.compose.ui.state.ToggleableState
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp

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
