package badlog.viewer.inspector

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
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
import androidx.compose.ui.unit.dp
import badlog.viewer.app.Viewer
import badlog.viewer.recording.OpenRecording
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.SearchField
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext

/** All events of [open] in the order of x. A click goes there; the one nearest to the cursor is marked. */
@Composable
internal fun EventsPanel(viewer: Viewer, open: OpenRecording, modifier: Modifier) {
    val isReady by produceState(false, open) {
        // Both are calculated when they are first asked for.
        withContext(Dispatchers.Default) {
            open.events
            open.enabled
        }
        value = true
    }
    if (!isReady) return
    val all = open.events.all
    if (all.size == 0) {
        PanelHint("This log has no events: none of its topics holds texts that say what happened.")
        return
    }
    val found = viewer.matchingEvents
    Column(modifier) {
        val filter = viewer.eventFilter
        SearchField(filter.text, "Search events", Modifier.fillMaxWidth().padding(8.dp)) {
            viewer.eventFilter = viewer.eventFilter.copy(text = it)
        }
        if (open.eventLogs.size > 1) EventTopics(viewer, open.eventLogs)
        Text(
            if (filter.isOff) countText(all.size, "event") else "${found.size} of ${countText(all.size, "event")}",
            Modifier.padding(horizontal = 12.dp, vertical = 2.dp),
            color = LocalPalette.current.muted,
        )
        if (found.size == 0) PanelHint("No event fits.") else EventList(viewer, open, found)
    }
}

@Composable
private fun EventList(viewer: Viewer, open: OpenRecording, found: MatchingEvents) {
    val times = remember(open) { EventTimes(open) }
    val state = rememberLazyListState()
    val nearest = remember(viewer, found) { derivedStateOf { viewer.cursor?.let { found.nearest(it) } ?: -1 } }
    FollowCursor(state, nearest)
    Box(Modifier.fillMaxSize()) {
        LazyColumn(Modifier.fillMaxSize(), state) {
            items(found.size) { index ->
                EventLine(found, index, times, isTopicShown = found.logs.size > 1, nearest) {
                    val x = found.x[index]
                    if (x.isFinite()) {
                        viewer.cursor = x
                        viewer.viewport = viewer.viewport.revealing(x)
                    }
                }
            }
        }
        VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
    }
}

/** Scrolls to the event [nearest] to the cursor when it is out of sight. */
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

/** `1 event`, `7 events`. */
internal fun countText(count: Int, one: String): String = "$count $one${if (count == 1) "" else "s"}"
