package badlog.window.sidebar

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.core.analysis.EventLog
import badlog.viewer.panel.eventsPanel
import badlog.viewer.shown.comparison.shortLabel
import badlog.viewer.state.Action
import badlog.window.log.AxisView
import badlog.window.log.FilteredEvents
import badlog.window.log.OpenRecording
import badlog.window.panel.PanelView
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext

/** All events of [open] in the order of x, see [eventsPanel]. */
@Composable
internal fun EventsPanel(view: AxisView, events: FilteredEvents, open: OpenRecording, send: (Action) -> Unit, modifier: Modifier) {
    val isReady by produceState(false, open) {
        // Both are calculated on first use.
        withContext(Dispatchers.Default) {
            open.events
            open.enabled
        }
        value = true
    }
    if (!isReady) return
    val all = open.events.size
    val found = events.matching
    val nearest by remember(view, found) { derivedStateOf { view.cursor?.let(found::nearest) ?: -1 } }
    val parts = remember(open, found, nearest) { eventsPanel(found, all, open.times, hasTopics = open.eventLogs.size > 1, nearest) }
    Column(modifier) {
        if (all > 0) {
            SearchField(events.state.text, "Search events", Modifier.fillMaxWidth().padding(8.dp)) { events.change { copy(text = it) } }
            if (open.eventLogs.size > 1) EventTopics(events, open.eventLogs)
        }
        PanelView(parts, goal = nearest, send, Modifier.weight(1f))
    }
}

/** Selects the topics of the listed events. */
@Composable
private fun EventTopics(events: FilteredEvents, logs: List<EventLog>) {
    val chosen = events.state.topicsOf(logs)
    FlowRow(Modifier.padding(horizontal = 8.dp).heightIn(max = 120.dp).verticalScroll(rememberScrollState())) {
        ToolButton("Events of all topics", text = "All", isOn = chosen.isEmpty()) {
            events.change { copy(topics = emptySet()) }
        }
        for (log in logs.take(MAX_TOPICS)) {
            ToolButton(
                "Events of ${log.name}",
                text = shortLabel(log.title, MAX_TITLE_LENGTH),
                isOn = log.name in chosen,
                modifier = Modifier.widthIn(max = 180.dp),
            ) { events.change { toggled(log.name) } }
        }
    }
}

/** The largest number of topics to select from; for others, use the search. */
private const val MAX_TOPICS = 40

/** The number of letters that fit into a button, which would cut off the end of a longer text. */
private const val MAX_TITLE_LENGTH = 24
