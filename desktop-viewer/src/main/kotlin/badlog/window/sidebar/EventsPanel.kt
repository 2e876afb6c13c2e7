package badlog.window.sidebar

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.State
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.core.analysis.EventLog
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.panel.LogTimes
import badlog.viewer.shown.comparison.shortLabel
import badlog.viewer.state.PlaceAction
import badlog.viewer.text.countOf
import badlog.window.log.AxisView
import badlog.window.log.FilteredEvents
import badlog.window.log.OpenRecording
import badlog.window.panel.inspectorLine
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext

/** All events of [open] in the order of x. A click goes there and calls [onGo]; the event nearest to the cursor is highlighted. */
@Composable
internal fun EventsPanel(view: AxisView, events: FilteredEvents, open: OpenRecording, onGo: () -> Unit, modifier: Modifier) {
    val isReady by produceState(false, open) {
        // Both are calculated on first use.
        withContext(Dispatchers.Default) {
            open.events
            open.enabled
        }
        value = true
    }
    if (!isReady) return
    val all = open.events
    if (all.size == 0) {
        PanelHint("This log has no events: no topic contains event texts.")
        return
    }
    val found = events.matching
    Column(modifier) {
        val filter = events.state
        SearchField(filter.text, "Search events", Modifier.fillMaxWidth().padding(8.dp)) {
            events.change { copy(text = it) }
        }
        if (open.eventLogs.size > 1) EventTopics(events, open.eventLogs)
        Text(
            countOf(found.size, all.size, "event"),
            Modifier.padding(horizontal = 12.dp, vertical = 2.dp),
            color = LocalPalette.current.muted,
        )
        if (found.size == 0) PanelHint("No event matches.") else EventList(view, open, found, onGo)
    }
}

@Composable
private fun EventList(view: AxisView, open: OpenRecording, found: EventTimeline, onGo: () -> Unit) {
    val times = open.times
    val state = rememberLazyListState()
    val nearest = remember(view, found) { derivedStateOf { view.cursor?.let { found.nearest(it) } ?: -1 } }
    FollowCursor(state, nearest)
    Box(Modifier.fillMaxSize()) {
        LazyColumn(Modifier.fillMaxSize(), state) {
            items(found.size) { index ->
                EventLine(found, index, times, isTopicShown = open.eventLogs.size > 1, nearest) {
                    val x = found.x[index]
                    if (x.isFinite()) {
                        view.send(PlaceAction.GoTo(x))
                        onGo()
                    }
                }
            }
        }
        VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
    }
}

/** Scrolls to the event [nearest] to the cursor if it is not visible. */
@Composable
private fun FollowCursor(state: LazyListState, nearest: State<Int>) {
    LaunchedEffect(state, nearest.value) {
        val index = nearest.value
        val visible = state.layoutInfo.visibleItemsInfo
        if (index < 0 || visible.isEmpty()) return@LaunchedEffect
        if (index <= visible.first().index || index >= visible.last().index) {
            state.scrollToItem(maxOf(0, index - visible.size / 2))
        }
    }
}

/** Event [index] of [events]: its time and text. */
@Composable
internal fun EventLine(
    events: EventTimeline,
    index: Int,
    times: LogTimes,
    isTopicShown: Boolean,
    nearest: State<Int>,
    onClick: () -> Unit,
) {
    val palette = LocalPalette.current
    val isNearest by remember(nearest, index) { derivedStateOf { nearest.value == index } }
    val x = events.x[index]
    val text = events.textOf(index)
    Row(
        Modifier.inspectorLine("Event at ${times.logged(x)}: $text", isNearest, gap = 3.dp, onClick),
        horizontalArrangement = Arrangement.spacedBy(10.dp),
    ) {
        Column(Modifier.width(64.dp)) {
            val since = times.sinceEnabled(x)
            Text(since ?: times.logged(x), Modifier.fillMaxWidth(), textAlign = TextAlign.End, maxLines = 1)
            if (since != null) {
                Text(
                    times.logged(x),
                    Modifier.fillMaxWidth(),
                    color = palette.muted,
                    fontSize = 11.sp,
                    textAlign = TextAlign.End,
                    maxLines = 1,
                )
            }
        }
        Column(Modifier.weight(1f)) {
            Text(text, maxLines = 4, overflow = TextOverflow.Ellipsis)
            if (isTopicShown) {
                NameText(events.topicOf(index), color = palette.muted, fontSize = 11.sp)
            }
        }
    }
}

/** Selects the topics of the listed events. */
@Composable
internal fun EventTopics(events: FilteredEvents, logs: List<EventLog>) {
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
