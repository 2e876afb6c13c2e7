package badlog.window.topics

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.window.graph.quoted
import badlog.window.log.GraphBoard
import badlog.window.menu.ClosesByEscape
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/**
 * The line above the list of topics that names the graph to which a click adds a topic. It has a button that ends this, and is empty if
 * each topic gets its own graph.
 */
@Composable
internal fun TargetLine(board: GraphBoard, topics: TopicListing) {
    val wanted = topics.state.target ?: return
    val target = targetOf(board, topics)
    // Another graph may get the same id later.
    LaunchedEffect(wanted, target == null) { if (target == null) topics.change { adding(null) } }
    if (target == null) return
    ClosesByEscape(isOpen = true) { topics.change { adding(null) } }
    Row(
        Modifier.fillMaxWidth().background(LocalPalette.current.accentSoft).padding(start = 12.dp, end = 4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text("Click topics to add to ${quoted(board, target)}", Modifier.weight(1f), maxLines = 3, overflow = TextOverflow.Ellipsis)
        ToolButton("Stop adding topics (Esc)", text = "Done") { topics.change { adding(null) } }
    }
}
