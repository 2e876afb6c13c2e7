package badlog.viewer.compare

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.viewer.app.Viewer
import badlog.viewer.text.wordsOf
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.SearchField
import badlog.viewer.theme.Tip

/** Chooses among [topics] those that the table has; the chosen ones stand first, as they always must be found. */
@Composable
internal fun StatisticsTopics(viewer: Viewer, topics: List<String>, modifier: Modifier) {
    var query by remember { mutableStateOf("") }
    val chosen = viewer.statisticsChoice.topics
    val listed = remember(topics, query, chosen) {
        val words = wordsOf(query)
        val found = topics.filter { topic -> words.all { topic.contains(it, ignoreCase = true) } }
        chosen + (found - chosen.toSet())
    }
    val state = rememberLazyListState()
    Column(modifier) {
        SearchField(query, "Search topics for the table", Modifier.fillMaxWidth().padding(8.dp)) { query = it }
        Box(Modifier.fillMaxSize()) {
            LazyColumn(Modifier.fillMaxSize(), state) {
                items(listed) { topic ->
                    TopicChoice(topic, topic in chosen) { viewer.statisticsChoice = viewer.statisticsChoice.toggled(topic) }
                }
            }
            VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

@Composable
private fun TopicChoice(topic: String, isChosen: Boolean, onClick: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .background(if (isChosen) palette.accentSoft else Color.Transparent)
            .clickable(onClick = onClick)
            .semantics {
                contentDescription = "Figures of $topic"
                selected = isChosen
            }
            .padding(horizontal = 8.dp, vertical = 4.dp),
        Arrangement.spacedBy(6.dp),
        Alignment.CenterVertically,
    ) {
        Box(Modifier.size(14.dp)) {
            if (isChosen) Icon(Icons.Check, contentDescription = null, Modifier.size(14.dp), palette.accent)
        }
        Tip(topic, Modifier.weight(1f)) { Text(topic, maxLines = 1, overflow = TextOverflow.Ellipsis) }
    }
}
