package badlog.window.sidebar

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.text.selection.SelectionContainer
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.core.recording.PathName
import badlog.core.recording.Value
import badlog.viewer.shown.search.Query
import badlog.window.log.OpenRecording
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.SearchField
import badlog.window.theme.Tip
import badlog.window.theme.ToolButton

/** The values that were known when the recording began, by folder. */
@Composable
internal fun ValuesPanel(open: OpenRecording, modifier: Modifier) {
    if (open.view.recording.values.isEmpty()) {
        PanelHint("This log has no metadata: its header is empty.")
        return
    }
    var query by remember { mutableStateOf("") }
    val rows = remember(open, query) { valueRows(open, query) }
    val state = rememberLazyListState()
    Column(modifier) {
        SearchField(query, "Search metadata", Modifier.fillMaxWidth().padding(8.dp)) { query = it }
        if (rows.isEmpty()) PanelHint("Nothing matches “$query”.")
        Box(Modifier.fillMaxSize()) {
            SelectionContainer {
                LazyColumn(Modifier.fillMaxSize(), state) {
                    items(rows) { row ->
                        if (row.value == null) FolderHeading(row.folder) else ValueLine(row.value)
                    }
                }
            }
            VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

/**
 * A line of the list of values.
 *
 * @property value the value; null for the heading of [folder].
 */
internal class ValueRow(val folder: String, val value: Value?)

/**
 * Returns the values of [open] with all words of [query] in their name or text, each folder below its heading. The root folder has no
 * heading.
 */
internal fun valueRows(open: OpenRecording, query: String): List<ValueRow> {
    val wanted = Query(query)
    return open.view.folders.flatMap { folder ->
        val found = folder.values.filter { wanted.matches("${it.name} ${it.text}") }
        val heading = if (found.isEmpty() || folder.name.isEmpty()) emptyList() else listOf(ValueRow(folder.name, null))
        heading + found.map { ValueRow(folder.name, it) }
    }
}

@Composable
private fun FolderHeading(name: String) {
    NameText(
        name,
        Modifier.padding(start = 12.dp, end = 12.dp, top = 10.dp, bottom = 2.dp),
        fontWeight = FontWeight.SemiBold,
    )
}

@Composable
private fun ValueLine(value: Value) {
    val copy = rememberCopy()
    Row(
        Modifier.fillMaxWidth().padding(start = 12.dp, end = 10.dp),
        horizontalArrangement = Arrangement.spacedBy(8.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Tip(value.name, Modifier.weight(0.42f)) {
            NameText(PathName.baseNameOf(value.name), color = LocalPalette.current.muted)
        }
        Text(value.text.ifEmpty { "–" }, Modifier.weight(0.58f), maxLines = 12, overflow = TextOverflow.Ellipsis)
        ToolButton("Copy ${value.name}", Icons.Copy) { copy(value.text) }
    }
}
