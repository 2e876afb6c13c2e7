package badlog.window.topics

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
import badlog.viewer.state.GraphChange
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/** The actions for the selected topics. */
@Composable
internal fun SelectedTopics(current: CurrentRecording, board: GraphBoard, topics: TopicListing) {
    val selected = topics.state.selected
    val draw = { change: (List<String>) -> Unit ->
        change(selected.filter { name -> current.recording?.run { signal(name)?.let { !isEvents(it) } } == true })
        topics.change { copy(selected = emptyList()) }
    }
    HorizontalDivider()
    Column(Modifier.fillMaxWidth().background(LocalPalette.current.accentSoft).padding(start = 8.dp, end = 4.dp, bottom = 4.dp)) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            Text("${selected.size} selected", Modifier.weight(1f), maxLines = 1)
            ToolButton("Clear the selection of topics", Icons.Close) { topics.change { copy(selected = emptyList()) } }
        }
        FlowRow {
            ToolButton("New graph of the selected topics", text = "New graph") {
                draw { board.send(GraphChange.Add(it)) }
            }
            ToolButton("Show only these topics", text = "Only these") {
                draw { names -> board.send(GraphChange.ShowOnlyLines(names)) }
            }
            ToolButton("A graph for each selected topic", text = "Separate graphs") {
                draw { names -> board.send(GraphChange.AddEach(names)) }
            }
            ToolButton("Add these to the last graph", text = "Add to last graph") {
                draw { board.send(GraphChange.AddToLast(it)) }
            }
        }
    }
}
