package badlog.viewer.topic

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.app.Viewer
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton

/** What can be done with the topics that are chosen. */
@Composable
internal fun ChosenTopics(viewer: Viewer) {
    val chosen = viewer.topicList.chosen
    val draw = { change: (List<String>) -> Unit ->
        change(chosen.filter { name -> viewer.open?.run { signal(name)?.let { !isEvents(it) } } == true })
        viewer.topicList = viewer.topicList.copy(chosen = emptyList())
    }
    HorizontalDivider()
    Column(Modifier.fillMaxWidth().background(LocalPalette.current.accentSoft).padding(start = 8.dp, end = 4.dp, bottom = 4.dp)) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            Text("${chosen.size} chosen", Modifier.weight(1f), maxLines = 1)
            ToolButton("Choose none", Icons.Close) { viewer.topicList = viewer.topicList.copy(chosen = emptyList()) }
        }
        FlowRow {
            ToolButton("One graph of these", text = "One graph") {
                draw { viewer.graphs = viewer.graphs.withGraph(it) }
            }
            ToolButton("A graph of each of these", text = "One each") {
                draw { names -> viewer.graphs = names.fold(viewer.graphs) { list, name -> list.withGraph(listOf(name)) } }
            }
            ToolButton("Add these to the last graph", text = "To last") {
                draw { viewer.graphs = viewer.graphs.withLinesInLast(it) }
            }
        }
    }
}
