package badlog.window.panel

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.selection.toggleable
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextDecoration
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.core.recording.Severity
import badlog.viewer.panel.Cell
import badlog.viewer.panel.Check
import badlog.viewer.state.Action
import badlog.viewer.text.word
import badlog.window.findings.findingColor
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.Palette
import badlog.window.theme.Tip

/**
 * Shows [cell]. A press has the effect [open]; null for the effect of the row.
 *
 * @param row the name of its row for screen readers, which they say if a press on it has an effect of its own.
 * @param isHovered whether the pointer is over its row.
 * @param takesFocus whether keys reach it; otherwise they move from row to row.
 */
@Composable
internal fun CellView(
    cell: Cell,
    row: String,
    color: Color,
    weight: FontWeight,
    isHovered: Boolean,
    send: (Action) -> Unit,
    open: Action? = cell.open,
    takesFocus: Boolean = false,
) {
    val palette = LocalPalette.current
    val pressed = if (open == null) {
        Modifier
    } else {
        Modifier
            .focusProperties { canFocus = takesFocus }
            .clickable(role = Role.Button) { send(open) }
            .semantics { contentDescription = "${cell.severity?.let { "${it.word}: " }.orEmpty()}${cell.text} · $row" }
    }
    val content = @Composable {
        Row(horizontalArrangement = Arrangement.spacedBy(6.dp), verticalAlignment = Alignment.CenterVertically) {
            cell.isUnfolded?.let { isOpen ->
                Icon(if (isOpen) Icons.Down else Icons.Right, contentDescription = null, Modifier.size(14.dp), palette.muted)
            }
            val severity = cell.severity
            ShareBar(cell)
            if (severity != null && cell.share == null) SeverityWord(severity)
            cell.preview?.let { PreviewCurve(it, palette.accent, Modifier.fillMaxWidth().height(20.dp)) }
            val decoration = TextDecoration.Underline.takeIf { isHovered && open != null }
            // Of names, the beginning and the end matter; of sentences, the beginning.
            if (cell.open != null && severity == null) {
                NameText(cell.text, Modifier, color, fontWeight = weight, textDecoration = decoration, cut = NameCut.FILE)
            } else {
                Text(
                    cell.text,
                    color = color,
                    fontWeight = weight,
                    maxLines = 1,
                    textDecoration = decoration,
                    overflow = TextOverflow.Ellipsis,
                )
            }
        }
    }
    // The link is outside the tooltip, because a click may begin before the tooltip appears.
    Box(pressed) {
        // A tooltip costs as much as the rest of the row, so only the one under the pointer has it.
        if (isHovered && cell.hint != cell.text) Tip(cell.hint) { content() } else content()
    }
}

@Composable
private fun SeverityWord(severity: Severity) {
    val color = LocalPalette.current.findingColor(severity)
    val shape = when (severity) {
        Severity.ERROR -> Icons.Diamond
        Severity.WARNING -> Icons.Warning
        Severity.NOTE -> Icons.Info
    }
    Row(horizontalArrangement = Arrangement.spacedBy(3.dp), verticalAlignment = Alignment.CenterVertically) {
        Icon(shape, contentDescription = null, Modifier.size(12.dp), color)
        Text(severity.word, color = color, fontSize = 12.sp, fontWeight = FontWeight.Medium, maxLines = 1)
    }
}

/** The bar of [cell], if it has one. */
@Composable
internal fun ShareBar(cell: Cell) {
    val share = cell.share ?: return
    val palette = LocalPalette.current
    val color = cell.severity?.let(palette::findingColor) ?: palette.muted
    val shape = RoundedCornerShape(3.dp)
    Box(Modifier.width(48.dp).height(6.dp).background(palette.raised, shape)) {
        Box(Modifier.width((48 * share).dp).height(6.dp).background(color, shape))
    }
}

/** A small check box. */
@Composable
internal fun CheckView(check: Check, send: (Action) -> Unit) {
    val palette = LocalPalette.current
    val shape = RoundedCornerShape(3.dp)
    Box(
        Modifier
            .toggleable(check.isOn, role = Role.Checkbox) { send(check.action) }
            .semantics { contentDescription = check.label }
            .padding(6.dp)
            .size(14.dp)
            .background(if (check.isOn) palette.accent else Color.Transparent, shape)
            .border(1.dp, if (check.isOn) palette.accent else palette.muted.copy(alpha = 0.5f), shape),
        contentAlignment = Alignment.Center,
    ) {
        if (check.isOn) Icon(Icons.Check, contentDescription = null, Modifier.size(12.dp), palette.surface)
    }
}

/** Returns the background of a row. */
internal fun rowColor(palette: Palette, isSelected: Boolean, isHovered: Boolean): Color = when {
    isSelected -> palette.accentSoft
    isHovered -> palette.raised
    else -> Color.Transparent
}
