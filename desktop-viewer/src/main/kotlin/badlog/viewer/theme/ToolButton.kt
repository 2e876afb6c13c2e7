package badlog.viewer.theme

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
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp

/**
 * A small button of an icon, of a text, or of both.
 *
 * @param description what it does: its tip, and what screen readers and tests know it by.
 * @param text what stands on it, or null for the icon alone.
 * @param color of what stands on it while it is neither on nor disabled.
 * @param isOn whether it stands for something that is on.
 */
@Composable
internal fun ToolButton(
    description: String,
    icon: ImageVector? = null,
    text: String? = null,
    isOn: Boolean = false,
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
        isOn -> palette.accent
        else -> color
    }
    val background = when {
        isOn -> palette.accentSoft
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
                .semantics { contentDescription = description }
                .padding(6.dp),
            horizontalArrangement = Arrangement.spacedBy(6.dp),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            if (icon != null) Icon(icon, contentDescription = null, Modifier.size(16.dp), tint)
            if (text != null) Text(text, color = tint, maxLines = 1)
        }
    }
}

/** Explains [content] by [text] when the pointer rests on it. */
@Composable
internal fun Tip(text: String, modifier: Modifier = Modifier, content: @Composable () -> Unit) = Tip({ text }, modifier, content)

/** The same with a text that is only found out then. */
@OptIn(ExperimentalFoundationApi::class)
@Composable
internal fun Tip(text: () -> String, modifier: Modifier = Modifier, content: @Composable () -> Unit) {
    TooltipArea(
        tooltip = {
            val palette = LocalPalette.current
            Text(
                remember(text) { text() },
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
