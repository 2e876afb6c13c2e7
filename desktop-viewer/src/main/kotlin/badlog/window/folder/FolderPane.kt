package badlog.window.folder

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Part
import badlog.viewer.panel.Table
import badlog.viewer.state.Action
import badlog.window.panel.ButtonsView
import badlog.window.panel.PanelView
import badlog.window.panel.PartView
import badlog.window.panel.WideTableView
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/**
 * Shows a panel about the folder's logs in the middle of the window. The first of its [parts] is its heading. A table at its end has room
 * for its columns, and scrolls below all others.
 *
 * @param scale the size of the others, compared with other panels.
 */
@Composable
internal fun FolderPane(
    parts: List<Part>,
    library: Library,
    actions: LibraryActions,
    send: (Action) -> Unit,
    modifier: Modifier = Modifier,
    scale: Float = 1f,
) {
    val heading = parts.first() as Heading
    val table = parts.last() as? Table
    val act = sendTo(library, actions, others = send)
    val density = LocalDensity.current
    Column(modifier.background(LocalPalette.current.surface).semantics { contentDescription = heading.title }) {
        FlowRow(Modifier.fillMaxWidth().padding(8.dp), Arrangement.spacedBy(6.dp), itemVerticalAlignment = Alignment.CenterVertically) {
            Text(heading.title, Modifier.weight(1f).padding(start = 4.dp), fontSize = 16.sp, fontWeight = FontWeight.SemiBold)
            ButtonsView(heading.tools, send)
            ToolButton("Back to the graphs", Icons.Graph, text = "Graphs") { actions.showGraphs() }
        }
        HorizontalDivider()
        ReadingLine(library)
        CompositionLocalProvider(LocalDensity provides Density(density.density * scale, density.fontScale)) {
            if (table == null) {
                PanelView(parts.drop(1), goal = null, act, Modifier.fillMaxSize())
            } else {
                BoxWithConstraints(Modifier.fillMaxSize()) {
                    val most = maxHeight / 2
                    Column {
                        Column(Modifier.heightIn(max = most).verticalScroll(rememberScrollState())) {
                            for (part in parts.drop(1).dropLast(1)) PartView(part, act)
                        }
                        WideTableView(table, act)
                    }
                }
            }
        }
    }
}
