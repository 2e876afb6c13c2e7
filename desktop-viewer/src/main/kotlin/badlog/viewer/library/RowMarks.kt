package badlog.viewer.library

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.selection.toggleable
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.library.index.LogEntry
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.Tip

/** A small box to tick. */
@Composable
internal fun TickBox(description: String, isTicked: Boolean, onTick: () -> Unit) {
    val palette = LocalPalette.current
    val shape = RoundedCornerShape(3.dp)
    Box(
        Modifier
            .toggleable(isTicked, role = Role.Checkbox) { onTick() }
            .semantics { contentDescription = description }
            .padding(6.dp)
            .size(14.dp)
            .background(if (isTicked) palette.accent else Color.Transparent, shape)
            .border(1.dp, if (isTicked) palette.accent else palette.muted.copy(alpha = 0.5f), shape),
        contentAlignment = Alignment.Center,
    ) {
        if (isTicked) Icon(Icons.Check, contentDescription = null, Modifier.size(12.dp), palette.surface)
    }
}

/** A dot in the alliance's colour. */
@Composable
internal fun AllianceMark(entry: LogEntry) {
    val palette = LocalPalette.current
    val colour = when (entry.match.alliance) {
        "Red" -> if (palette.isDark) Color(0xFFFF6B60) else Color(0xFFD0342C)
        "Blue" -> if (palette.isDark) Color(0xFF5AA9FF) else Color(0xFF1F66D0)
        else -> return
    }
    Tip("${entry.match.alliance} alliance") { Box(Modifier.size(8.dp).background(colour, CircleShape)) }
}

/** How many problems matter; nothing when none does. */
@Composable
internal fun ProblemBadge(entry: LogEntry) {
    val text = problemText(entry) ?: return
    val palette = LocalPalette.current
    val isError = entry.problems.errors > 0 || !entry.isReadable
    val colour = if (isError) palette.error else palette.warning
    Tip(problemSentence(entry)) {
        Row(
            Modifier
                .background(if (isError) palette.errorSoft else palette.warningSoft, RoundedCornerShape(8.dp))
                .padding(horizontal = 5.dp),
            horizontalArrangement = Arrangement.spacedBy(3.dp),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            Icon(Icons.Warning, contentDescription = null, Modifier.size(11.dp), colour)
            if (entry.isReadable) Text(text, color = colour, fontSize = 11.sp, lineHeight = 16.sp)
        }
    }
}
