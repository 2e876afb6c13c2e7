package badlog.window.robot

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/** The line at the bottom of the window while it records: log, amount of data, and connection to the robot. */
@Composable
internal fun RecordingLine(recording: RobotRecording) {
    val state = recording.state
    if (!state.isOn) return
    val palette = LocalPalette.current
    Row(
        Modifier.fillMaxWidth().background(palette.surface).padding(start = 12.dp, end = 4.dp),
        horizontalArrangement = Arrangement.spacedBy(10.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Box(Modifier.size(9.dp).background(if (state.file == null) palette.muted else palette.error, CircleShape))
        // The amount changes too often to be spoken.
        if (state.file != null) Text(state.amount, maxLines = 1, softWrap = false)
        Text(
            listOfNotNull(state.waiting, state.connection).joinToString(" "),
            Modifier.weight(1f).semantics { liveRegion = LiveRegionMode.Polite },
            color = palette.muted,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
        ToolButton("Stop recording", text = "Stop recording") { recording.stop() }
    }
}
