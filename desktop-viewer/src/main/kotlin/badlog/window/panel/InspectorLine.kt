package badlog.window.panel

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import badlog.window.theme.LocalPalette

/** Makes an element a clickable line of a list, called [name], with [gap] above and below. */
@Composable
internal fun Modifier.inspectorLine(name: String, isSelected: Boolean, gap: Dp, onClick: () -> Unit): Modifier = fillMaxWidth()
    .background(if (isSelected) LocalPalette.current.accentSoft else Color.Transparent)
    .clickable(onClick = onClick)
    .semantics(mergeDescendants = true) {
        contentDescription = name
        selected = isSelected
    }
    .padding(start = 12.dp, end = 14.dp, top = gap, bottom = gap)
