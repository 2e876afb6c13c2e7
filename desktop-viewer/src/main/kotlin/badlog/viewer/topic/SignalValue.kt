package badlog.viewer.topic

import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.analysis.Series
import badlog.viewer.app.Viewer
import badlog.viewer.recording.OpenRecording
import badlog.viewer.recording.Signal
import badlog.viewer.recording.valueText
import badlog.viewer.theme.LocalPalette
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext

/** The value of [signal] under the cursor, or how many events it has. A leaf, as it changes while the pointer moves. */
@Composable
internal fun SignalValue(viewer: Viewer, open: OpenRecording, signal: Signal) {
    if (open.isEvents(signal)) {
        val count = signal.topic.texts.size
        ValueText(if (count == 1) "1 event" else "$count events")
        return
    }
    val series by produceState<Series?>(null, signal) {
        // Samples are calculated when they are first asked for.
        value = withContext(Dispatchers.Default) { signal.series.also { it.isOrdered } }
    }
    val text by remember(viewer, signal) { derivedStateOf { series?.let { valueText(signal, it, viewer.cursor) }.orEmpty() } }
    ValueText(text)
}

@Composable
private fun ValueText(text: String) {
    Text(
        text,
        Modifier.widthIn(max = 104.dp),
        color = LocalPalette.current.muted,
        textAlign = TextAlign.End,
        maxLines = 1,
        overflow = TextOverflow.Ellipsis,
    )
}
