package badlog.viewer.menu

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.vector.ImageVector
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.viewer.theme.LocalPalette

/** A line of a menu, which [mark] marks as chosen. */
@Composable
internal fun MenuLine(text: String, mark: ImageVector? = null, onClick: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .widthIn(min = 180.dp, max = 420.dp)
            .clickable(role = Role.Button, onClick = onClick)
            .padding(horizontal = 12.dp, vertical = 6.dp),
        horizontalArrangement = Arrangement.spacedBy(8.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text(text, Modifier.weight(1f), maxLines = 1, overflow = TextOverflow.MiddleEllipsis)
        if (mark != null) Icon(mark, contentDescription = "chosen", Modifier.size(14.dp), palette.accent)
    }
}
