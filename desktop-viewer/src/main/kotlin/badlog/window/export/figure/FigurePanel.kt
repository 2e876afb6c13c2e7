package badlog.window.export.figure

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Checkbox
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.titles
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.ToolButton

/** The panel for saving a figure: its graphs, size, and format. */
@Composable
internal fun FigurePanel(graphs: List<BoardGraph>, save: (List<BoardGraph>, FigureOptions) -> Unit, close: () -> Unit) {
    var selected by remember { mutableStateOf(graphs.take(SELECTED_FIRST).map { it.id }.toSet()) }
    var options by remember { mutableStateOf(FigureOptions()) }
    Column(Modifier.padding(horizontal = 14.dp, vertical = 6.dp), verticalArrangement = Arrangement.spacedBy(8.dp)) {
        Text("Figure for a report", fontWeight = FontWeight.SemiBold)
        GraphChoice(graphs, selected) { selected = it }
        Choice("File", FigureFormat.entries, options.format, { it.name }) { options = options.copy(format = it) }
        Text(options.format.meaning, color = LocalPalette.current.muted, fontSize = 11.sp)
        Choice("Width", WIDTHS, options.width, { it.toString() }) { options = options.copy(width = it) }
        Choice("Graph height", HEIGHTS, options.graphHeight, { it.toString() }) { options = options.copy(graphHeight = it) }
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp, Alignment.End)) {
            ToolButton("Close without a figure", text = "Cancel", onClick = close)
            ToolButton("Save the figure", text = "Save…", isOn = selected.isNotEmpty(), isEnabled = selected.isNotEmpty()) {
                close()
                save(graphs.filter { it.id in selected }, options)
            }
        }
    }
}

@Composable
private fun GraphChoice(graphs: List<BoardGraph>, selected: Set<Int>, onChange: (Set<Int>) -> Unit) {
    Row(horizontalArrangement = Arrangement.spacedBy(4.dp), verticalAlignment = Alignment.CenterVertically) {
        Text("${selected.size} of ${graphs.size} graphs", Modifier.weight(1f), LocalPalette.current.muted, fontSize = 11.sp)
        ToolButton("Select all graphs", text = "All") { onChange(graphs.map { it.id }.toSet()) }
        ToolButton("Select no graph", text = "None") { onChange(emptySet()) }
    }
    Column(Modifier.heightIn(max = 220.dp).verticalScroll(rememberScrollState())) {
        for ((graph, title) in graphs.zip(Board(graphs).titles).take(MAX_OFFERED)) {
            val isSelected = graph.id in selected
            Row(
                Modifier
                    .fillMaxWidth()
                    .clickable(role = Role.Checkbox) { onChange(if (isSelected) selected - graph.id else selected + graph.id) }
                    .semantics { contentDescription = "In the figure: $title" }
                    .padding(vertical = 3.dp),
                Arrangement.spacedBy(8.dp),
                Alignment.CenterVertically,
            ) {
                Checkbox(isSelected, onCheckedChange = null, Modifier.size(16.dp))
                NameText(title)
            }
        }
    }
}

@Composable
private fun <T> Choice(title: String, all: List<T>, selected: T, name: (T) -> String, onChange: (T) -> Unit) {
    Row(horizontalArrangement = Arrangement.spacedBy(4.dp), verticalAlignment = Alignment.CenterVertically) {
        Text(title, Modifier.weight(1f))
        for (one in all) ToolButton("$title: ${name(one)}", text = name(one), isOn = one == selected) { onChange(one) }
    }
}

private val WIDTHS = listOf(600, 900, 1400)
private val HEIGHTS = listOf(100, 150, 240)

/** The number of graphs selected at first; more do not fit on a page of a report. */
private const val SELECTED_FIRST = 6

/** The largest number of graphs to select from; for others, remove graphs in the window first. */
private const val MAX_OFFERED = 200

/**
 * A person's options for a figure.
 *
 * @property width its width, in points of SVG.
 * @property graphHeight the height of one graph's lines, in points of SVG; lanes add their own height.
 * @property format the kind of file.
 */
internal data class FigureOptions(val width: Int = 900, val graphHeight: Int = 150, val format: FigureFormat = FigureFormat.PNG)

/**
 * The kinds of file for a figure.
 *
 * @property ending the ending of such files' names.
 * @property meaning its purpose, for people.
 */
internal enum class FigureFormat(val ending: String, val meaning: String) {
    PNG("png", "for slides, documents and chats"),
    SVG("svg", "sharp at any size, and can be edited"),
}
