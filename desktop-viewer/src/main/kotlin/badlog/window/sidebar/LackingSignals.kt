package badlog.window.sidebar

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.shown.search.Query
import badlog.window.menu.MenuBox
import badlog.window.menu.MenuLine
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton

/** For each of the signals [lacking] a button that chooses the one of [topics] that it is, for all logs of the folder. */
@Composable
internal fun LackingSignals(lacking: List<String>, topics: List<String>, onAssign: (signal: String, topic: String) -> Unit) {
    var open by remember { mutableStateOf<String?>(null) }
    Column(Modifier.padding(start = 22.dp)) {
        for (signal in lacking) {
            val choice = @Composable {
                TopicsToChoose(topics) { topic ->
                    open = null
                    onAssign(signal, topic)
                }
            }
            MenuBox(open == signal, { open = null }, menu = choice) {
                ToolButton("Choose the topic for “$signal” in all logs of this folder", text = "“$signal” is …") { open = signal }
            }
        }
    }
}

@Composable
private fun TopicsToChoose(topics: List<String>, onChosen: (String) -> Unit) {
    var filter by remember { mutableStateOf("") }
    val shown = remember(topics, filter) { topics.filter(Query(filter)::matches) }
    // A menu measures its content before it knows its size, which a lazy list needs to know.
    Column(Modifier.width(280.dp).padding(horizontal = 8.dp)) {
        SearchField(filter, "Search topics for the signal") { filter = it }
        LazyColumn(Modifier.width(264.dp).height(240.dp)) {
            items(shown) { name -> MenuLine(name) { onChosen(name) } }
        }
    }
}
