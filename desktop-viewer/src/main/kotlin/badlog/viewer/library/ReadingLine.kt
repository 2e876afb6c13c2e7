package badlog.viewer.library

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.app.Viewer
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton

/** How far reading the folder is, and what hinders it; nothing when all is known. */
@Composable
internal fun ReadingLine(viewer: Viewer) {
    val library = viewer.library
    val palette = LocalPalette.current
    Column(Modifier.fillMaxWidth()) {
        library.trouble?.let { trouble ->
            Text(
                trouble,
                Modifier.fillMaxWidth().background(palette.warningSoft).padding(horizontal = 12.dp, vertical = 6.dp),
                color = palette.warning,
                fontSize = 12.sp,
                lineHeight = 16.sp,
                maxLines = 4,
                overflow = TextOverflow.Ellipsis,
            )
        }
        val reading = library.reading
        // One log that grows is read again and again: nothing that a person waits for.
        if (reading != null && reading.total > 1) {
            NoteLine("Reading ${reading.read} of ${reading.total} logs", "Stop", "Stop reading logs") {
                viewer.libraryFolder.stopReading()
            }
            LinearProgressIndicator(
                progress = { reading.read.toFloat() / reading.total },
                modifier = Modifier.fillMaxWidth().height(2.dp),
                gapSize = 0.dp,
                drawStopIndicator = {},
            )
        } else if (library.passedOver > 0) {
            val logs = if (library.passedOver == 1) "1 log is" else "${library.passedOver} logs are"
            NoteLine("$logs not read", "Read", "Read the other logs") { viewer.libraryFolder.readAll() }
        }
    }
}

@Composable
private fun NoteLine(text: String, action: String, description: String, onAction: () -> Unit) {
    Row(Modifier.padding(start = 12.dp, end = 4.dp), verticalAlignment = Alignment.CenterVertically) {
        val muted = LocalPalette.current.muted
        Text(text, Modifier.weight(1f), color = muted, fontSize = 12.sp, maxLines = 1, overflow = TextOverflow.Ellipsis)
        ToolButton(description, text = action, onClick = onAction)
    }
}
