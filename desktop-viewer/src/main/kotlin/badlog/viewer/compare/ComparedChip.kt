package badlog.viewer.compare

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.viewer.app.Viewer
import badlog.viewer.recording.OpenRecording
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.Tip
import badlog.viewer.theme.ToolButton

/** One of the recordings that are compared: its colour and name, and where it stands against the open one. */
@Composable
internal fun ComparedChip(viewer: Viewer, open: OpenRecording, drawn: DrawnRecording, color: Color) {
    val palette = LocalPalette.current
    val recording = drawn.recording
    val isOpen = recording.file == open.file
    Row(
        Modifier.border(1.dp, palette.border, RoundedCornerShape(6.dp)).padding(start = 8.dp, end = 2.dp, top = 1.dp, bottom = 1.dp),
        Arrangement.spacedBy(2.dp),
        Alignment.CenterVertically,
    ) {
        Box(Modifier.size(10.dp).background(color, RoundedCornerShape(2.dp)))
        Tip("${recording.label} (${recording.file.fileName})", Modifier.weight(1f, fill = false).padding(start = 6.dp, end = 6.dp)) {
            Text(
                shortLabel(drawn.name, letters = 28),
                Modifier.padding(vertical = 5.dp),
                maxLines = 1,
                overflow = TextOverflow.Ellipsis,
            )
        }
        if (isOpen) {
            Text("open", Modifier.padding(end = 8.dp), color = palette.muted)
        } else {
            val moveTo = { offset: Double -> viewer.comparison = viewer.comparison.movedTo(recording.file, offset, open) }
            for (step in STEPS.reversed()) Nudge(drawn.name, "-", step) { moveTo(rounded(drawn.offset - step)) }
            OffsetField(drawn.name, drawn.offset, moveTo)
            for (step in STEPS) Nudge(drawn.name, "+", step) { moveTo(rounded(drawn.offset + step)) }
            ToolButton("Compare no longer with ${drawn.name}", Icons.Close) { viewer.comparisonLoading.remove(recording.file) }
        }
    }
}

@Composable
private fun Nudge(label: String, sign: String, step: Double, onClick: () -> Unit) {
    ToolButton("Move $label by $sign$step", text = "$sign${step.toString().removePrefix("0").removeSuffix(".0")}", onClick = onClick)
}

/** By how much a click moves a recording, in units of x. */
private val STEPS = listOf(0.02, 0.1, 1.0)
