package badlog.viewer.export.figure

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
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.file.writeAtomically
import badlog.viewer.app.Viewer
import badlog.viewer.compare.drawnRecordings
import badlog.viewer.export.openAction
import badlog.viewer.files.askToWrite
import badlog.viewer.files.fileNameOf
import badlog.viewer.graph.GraphSpec
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton
import java.io.IOException
import java.nio.file.Path
import javax.imageio.ImageIO

/** What a person chooses before a figure is saved: which graphs, how large, and as what. */
@Composable
internal fun FigurePanel(viewer: Viewer, close: () -> Unit) {
    val graphs = viewer.graphs.graphs
    var chosen by remember { mutableStateOf(graphs.take(CHOSEN_FIRST).map { it.id }.toSet()) }
    var options by remember { mutableStateOf(FigureOptions()) }
    Column(Modifier.padding(horizontal = 14.dp, vertical = 6.dp), verticalArrangement = Arrangement.spacedBy(8.dp)) {
        Text("Figure for a report", fontWeight = FontWeight.SemiBold)
        GraphChoice(graphs, chosen) { chosen = it }
        Choice("File", FigureFormat.entries, options.format, { it.name }) { options = options.copy(format = it) }
        Text(options.format.meaning, color = LocalPalette.current.muted, fontSize = 11.sp)
        Choice("Width", WIDTHS, options.width, { it.toString() }) { options = options.copy(width = it) }
        Choice("Graph height", HEIGHTS, options.graphHeight, { it.toString() }) { options = options.copy(graphHeight = it) }
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp, Alignment.End)) {
            ToolButton("Close without a figure", text = "Cancel", onClick = close)
            ToolButton("Save the figure", text = "Save…", isOn = chosen.isNotEmpty(), isEnabled = chosen.isNotEmpty()) {
                close()
                saveFigure(viewer, graphs.filter { it.id in chosen }, options)
            }
        }
    }
}

@Composable
private fun GraphChoice(graphs: List<GraphSpec>, chosen: Set<Int>, onChange: (Set<Int>) -> Unit) {
    Row(horizontalArrangement = Arrangement.spacedBy(4.dp), verticalAlignment = Alignment.CenterVertically) {
        Text("${chosen.size} of ${graphs.size} graphs", Modifier.weight(1f), LocalPalette.current.muted, fontSize = 11.sp)
        ToolButton("Choose all graphs", text = "All") { onChange(graphs.map { it.id }.toSet()) }
        ToolButton("Choose no graph", text = "None") { onChange(emptySet()) }
    }
    Column(Modifier.heightIn(max = 220.dp).verticalScroll(rememberScrollState())) {
        for (graph in graphs.take(MOST_OFFERED)) {
            val isChosen = graph.id in chosen
            Row(
                Modifier
                    .fillMaxWidth()
                    .clickable(role = Role.Checkbox) { onChange(if (isChosen) chosen - graph.id else chosen + graph.id) }
                    .semantics { contentDescription = "In the figure: ${graph.title}" }
                    .padding(vertical = 3.dp),
                Arrangement.spacedBy(8.dp),
                Alignment.CenterVertically,
            ) {
                Checkbox(isChosen, onCheckedChange = null, Modifier.size(16.dp))
                Text(graph.title, maxLines = 1, overflow = TextOverflow.Ellipsis)
            }
        }
    }
}

@Composable
private fun <T> Choice(title: String, all: List<T>, chosen: T, name: (T) -> String, onChange: (T) -> Unit) {
    Row(horizontalArrangement = Arrangement.spacedBy(4.dp), verticalAlignment = Alignment.CenterVertically) {
        Text(title, Modifier.weight(1f))
        for (one in all) ToolButton("$title: ${name(one)}", text = name(one), isOn = one == chosen) { onChange(one) }
    }
}

private val WIDTHS = listOf(600, 900, 1400)
private val HEIGHTS = listOf(100, 150, 240)

/** More graphs fit no page of a report. */
private const val CHOSEN_FIRST = 6

/** A list of more is not to be read; who wants others takes graphs away in the window first. */
private const val MOST_OFFERED = 200

/** Asks for a file, and writes the figure of [graphs] as they are on the screen. */
internal fun saveFigure(viewer: Viewer, graphs: List<GraphSpec>, options: FigureOptions) {
    val recording = viewer.open ?: return
    val ending = ".${options.format.ending}"
    val file = askToWrite(viewer, "Save the figure", recording.file.parent, fileNameOf(recording.label), ending) ?: return
    val builder = FigureBuilder(viewer.drawnRecordings(), viewer.viewport.visible, options.width)
    viewer.tasks.run("Drawing ${file.fileName}", { writeFigure(drawable(builder.build(graphs)), options, file) }) {
        viewer.notices.say("Saved $file.", openAction(viewer, file))
    }
}

/** [figure], where there is anything in it to draw. */
internal fun drawable(figure: Figure): Figure =
    if (figure.frames.isEmpty()) throw IOException("None of the chosen graphs has a line in this log; choose others.") else figure

/** Writes [figure] to [file]. */
internal fun writeFigure(figure: Figure, options: FigureOptions, file: Path) {
    val svg = svgOf(figure, options)
    if (Thread.interrupted()) throw InterruptedException()
    when (options.format) {
        FigureFormat.SVG -> writeAtomically(file) { it.write(svg.encodeToByteArray()) }

        FigureFormat.PNG -> {
            val image = imageOf(svg, options.width, PICTURE_SCALE)
            writeAtomically(file) { ImageIO.write(image, "png", it) }
        }
    }
}
