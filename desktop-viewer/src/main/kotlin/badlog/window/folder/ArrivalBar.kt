package badlog.window.folder

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.core.recording.Severity
import badlog.viewer.input.ScreenKey
import badlog.viewer.shown.folder.arrivalText
import badlog.window.findings.findingColor
import badlog.window.findings.findingSoft
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/** Names the log that has arrived and its result, until a person shows or postpones it. Empty if none has arrived. */
@Composable
internal fun ArrivalBar(logs: NewLogs, onShow: () -> Unit) {
    val match = logs.state.latest ?: return
    val latest = match.worst
    val palette = LocalPalette.current
    val severity = latest.found?.verdict?.severity ?: Severity.NOTE
    Row(
        Modifier
            .fillMaxWidth()
            .background(palette.findingSoft(severity))
            .padding(horizontal = 12.dp, vertical = 4.dp)
            .semantics { contentDescription = "New log" },
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        Icon(Icons.Diamond, contentDescription = null, Modifier.size(16.dp), palette.findingColor(severity))
        Text(
            arrivalText(latest, logs.state.waiting.size - match.logs.size),
            Modifier.weight(1f).semantics { liveRegion = LiveRegionMode.Polite },
            fontWeight = FontWeight.Medium,
            maxLines = 2,
            overflow = TextOverflow.Ellipsis,
        )
        val hint = "Show the new log, at its worst finding (${ScreenKey.NEW_LOG.key.text})"
        ToolButton(hint, text = "Show", color = palette.accent, onClick = onShow)
        ToolButton("Hide this; the log stays in the list", text = "Later") { logs.leave() }
    }
}
