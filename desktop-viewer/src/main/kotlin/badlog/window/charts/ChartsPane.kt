package badlog.window.charts

import androidx.compose.foundation.Image
import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.grid.GridCells
import androidx.compose.foundation.lazy.grid.GridItemSpan
import androidx.compose.foundation.lazy.grid.LazyVerticalGrid
import androidx.compose.foundation.lazy.grid.items
import androidx.compose.foundation.lazy.grid.rememberLazyGridState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.FilterQuality
import androidx.compose.ui.graphics.toComposeImageBitmap
import androidx.compose.ui.layout.ContentScale
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.catalog.folder.LogEntry
import badlog.window.export.figure.FigureFormat
import badlog.window.folder.FolderTools
import badlog.window.folder.Library
import badlog.window.folder.LibraryActions
import badlog.window.folder.LibraryEmptiness
import badlog.window.folder.ReadingLine
import badlog.window.settings.SettingsStore
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import org.jetbrains.skia.Image as SkiaImage

/** Charts of the logs that the list shows. */
@Composable
internal fun ChartsPane(
    charts: FolderCharts,
    library: Library,
    settings: SettingsStore,
    actions: LibraryActions,
    modifier: Modifier = Modifier,
) {
    val visible = library.state.visible
    // The charts are in the order of play, however the list is sorted.
    val (examined, waiting) = remember(visible) {
        visible.filter { it.isReadable && !it.isGray }.sortedBy { it.path }.partition { it.found != null }
    }
    val wanted by rememberUpdatedState(examined)
    LaunchedEffect(charts) { charts.follow(snapshotFlow { wanted }) }
    val drawn = remember(charts.state, examined) { charts.state.chartsFor(examined) }
    Column(modifier.background(LocalPalette.current.surface)) {
        FolderTools(library, settings, actions) {
            ToolButton("All logs as a table", Icons.Table) { actions.toggleTable() }
        }
        HorizontalDivider()
        ReadingLine(library)
        if (visible.isEmpty()) {
            LibraryEmptiness(library, actions)
        } else {
            DrawingLine(charts, examined, waiting.size + (drawn?.unknown ?: 0))
            drawn?.let { ChartGrid(charts, it) }
        }
    }
}

/** The progress of drawing, or the reason why logs are left out; empty if the charts show all listed logs. */
@Composable
private fun DrawingLine(charts: FolderCharts, examined: List<LogEntry>, waiting: Int) {
    val text = when {
        charts.state.isDrawing -> "Drawing charts…"
        charts.state.isStopped -> "Drawing was stopped."
        waiting == 1 -> "Rules have not been run over 1 log yet; it is left out."
        waiting > 1 -> "Rules have not been run over $waiting logs yet; they are left out."
        examined.isEmpty() -> "None of these logs can be drawn."
        else -> return
    }
    Row(Modifier.padding(horizontal = 12.dp, vertical = 6.dp), Arrangement.spacedBy(8.dp), Alignment.CenterVertically) {
        Text(text, color = LocalPalette.current.muted, fontSize = 12.sp)
        if (charts.state.isStopped) ToolButton("Draw the charts of these logs", text = "Draw") { charts.draw(examined) }
    }
}

@Composable
private fun ChartGrid(charts: FolderCharts, drawn: DrawnCharts) {
    val grid = rememberLazyGridState()
    Box(Modifier.fillMaxSize()) {
        LazyVerticalGrid(
            GridCells.Adaptive(CHART_WIDTH),
            Modifier.fillMaxSize(),
            grid,
            PaddingValues(12.dp),
            verticalArrangement = Arrangement.spacedBy(12.dp),
            horizontalArrangement = Arrangement.spacedBy(12.dp),
        ) {
            items(drawn.all, key = { it.name }) { ChartCard(it) { format -> charts.save(it, format) } }
            items(drawn.lacking, span = { GridItemSpan(maxLineSpan) }) { Text(it, color = LocalPalette.current.muted, fontSize = 12.sp) }
        }
        VerticalScrollbar(rememberScrollbarAdapter(grid), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
    }
}

/** A chart on white, as on paper, in both themes; the saved picture looks the same. */
@Composable
private fun ChartCard(chart: DrawnChart, onSave: (FigureFormat) -> Unit) {
    val picture = remember(chart) { SkiaImage.makeFromEncoded(chart.bytes(FigureFormat.PNG)).use { it.toComposeImageBitmap() } }
    Column(Modifier.fillMaxWidth().clip(RoundedCornerShape(6.dp)).background(LocalPalette.current.raised)) {
        Image(
            picture,
            contentDescription = "${chart.title}. ${chart.question} ${chart.reading}",
            Modifier.fillMaxWidth().background(Color.White),
            contentScale = ContentScale.FillWidth,
            filterQuality = FilterQuality.High,
        )
        Row(Modifier.align(Alignment.End).padding(horizontal = 8.dp, vertical = 2.dp), Arrangement.spacedBy(4.dp)) {
            for (format in FigureFormat.entries) {
                ToolButton("Save “${chart.title}” as ${format.name}", text = "${format.name}…") { onSave(format) }
            }
        }
    }
}

private val CHART_WIDTH = 600.dp
