package badlog.window.graph

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.state.BoardAction
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/** The pane before a recording is open. */
@Composable
internal fun NothingOpen(isOpening: Boolean, modifier: Modifier) {
    if (isOpening) {
        Sentence("Opening the log…", "Its graphs appear in a moment; the line below shows the progress.", modifier.fillMaxSize())
    } else {
        Sentence("No log is open", "Select a log at the left, or drop a file here.", modifier.fillMaxSize())
    }
}

/** The pane if a recording has nothing to draw. */
@Composable
internal fun NothingRecorded(open: OpenRecording, modifier: Modifier) {
    Sentence("There is nothing to draw in this log", "${open.file.fileName} has no topic with a sample.", modifier)
}

/** The pane if a person has removed every graph. */
@Composable
internal fun NoGraphs(board: GraphBoard, open: OpenRecording, modifier: Modifier) {
    Sentence("No graphs", "Drag topics here, or start with the default graphs.", modifier) {
        ToolButton("Show the default graphs", Icons.Graph, text = "Show the default graphs", isOn = true) {
            board.send(BoardAction.ShowAll(open.standardGraphs))
        }
        if (board.canUndo) ToolButton("Show the previous graphs", Icons.Undo, text = "Undo") { board.undo() }
    }
}

@Composable
private fun Sentence(title: String, text: String, modifier: Modifier, action: @Composable () -> Unit = {}) {
    Column(
        modifier.padding(24.dp),
        verticalArrangement = Arrangement.spacedBy(8.dp, Alignment.CenterVertically),
        horizontalAlignment = Alignment.CenterHorizontally,
    ) {
        Text(title, fontSize = 17.sp)
        Text(
            text,
            color = LocalPalette.current.muted,
            textAlign = TextAlign.Center,
            maxLines = 4,
            overflow = TextOverflow.Ellipsis,
        )
        action()
    }
}
