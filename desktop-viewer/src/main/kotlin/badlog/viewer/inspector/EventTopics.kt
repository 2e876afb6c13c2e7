package badlog.viewer.inspector

import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.analysis.EventLog
import badlog.viewer.app.Viewer
import badlog.viewer.theme.ToolButton

/** Chooses the topics whose events are listed. */
@Composable
internal fun EventTopics(viewer: Viewer, logs: List<EventLog>) {
    val chosen = viewer.eventFilter.topicsOf(logs)
    FlowRow(Modifier.padding(horizontal = 8.dp).heightIn(max = 120.dp).verticalScroll(rememberScrollState())) {
        ToolButton("Events of all topics", text = "All", isOn = chosen.isEmpty()) {
            viewer.eventFilter = viewer.eventFilter.copy(topics = emptySet())
        }
        for (log in logs.take(MOST)) {
            ToolButton(
                "Events of ${log.name}",
                text = log.title.take(LONGEST),
                isOn = log.name in chosen,
                modifier = Modifier.widthIn(max = 180.dp),
            ) { viewer.eventFilter = viewer.eventFilter.toggled(log.name) }
        }
    }
}

/** Of more topics than these the search finds the events. */
private const val MOST = 40
private const val LONGEST = 40
