package badlog.viewer.inspector

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.width
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.State
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.theme.LocalPalette

/** Event [index] of [events]: when, and what. */
@Composable
internal fun EventLine(
    events: MatchingEvents,
    index: Int,
    times: EventTimes,
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
                Text(events.topicOf(index), color = palette.muted, fontSize = 11.sp, maxLines = 1, overflow = TextOverflow.Ellipsis)
            }
        }
    }
}
