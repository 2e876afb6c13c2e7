package badlog.viewer.findings

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.report.SkippedRule
import badlog.viewer.inspector.countText
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette

/** How many rules could not be asked; a click shows and hides which. */
@Composable
internal fun SkippedHead(count: Int, isOpen: Boolean, onToggle: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .clickable(role = Role.Button, onClick = onToggle)
            .padding(start = 8.dp, end = 14.dp, top = 8.dp, bottom = 4.dp),
        Arrangement.spacedBy(4.dp),
        Alignment.CenterVertically,
    ) {
        Icon(if (isOpen) Icons.Down else Icons.Right, contentDescription = null, Modifier.size(14.dp), palette.muted)
        Text("${countText(count, "rule")} could not be asked", color = palette.muted)
    }
}

/** A rule that could not be asked of the log, and why. */
@Composable
internal fun SkippedLine(rule: SkippedRule) {
    val palette = LocalPalette.current
    Column(Modifier.fillMaxWidth().padding(start = 26.dp, end = 14.dp, top = 3.dp, bottom = 3.dp)) {
        Text(rule.rule, maxLines = 1, overflow = TextOverflow.Ellipsis)
        if (rule.isMistake) {
            PointedText(rule.message)
        } else {
            Text(rule.message, color = palette.muted, fontSize = 12.sp, maxLines = 8, overflow = TextOverflow.Ellipsis)
        }
    }
}
