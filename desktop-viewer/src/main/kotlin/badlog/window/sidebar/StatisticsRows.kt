package badlog.window.sidebar

import androidx.compose.foundation.HorizontalScrollbar
import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.combinedClickable
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.core.analysis.Units
import badlog.core.recording.Topic
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.Tip
import java.nio.file.Path

/** The table of statistics without its tools. A click on a heading sorts by it; a double click on a row opens its recording. */
@Composable
internal fun StatisticsRows(
    statistics: SelectedStatistics,
    grid: StatisticsGrid,
    open: Path?,
    onOpen: (Path) -> Unit,
    modifier: Modifier,
) {
    val across = rememberScrollState()
    val down = rememberLazyListState()
    Box(modifier) {
        Column(Modifier.fillMaxSize().horizontalScroll(across).padding(bottom = 10.dp)) {
            val width = grid.columns.fold(0.dp) { sum, column -> sum + widthOf(column) }
            Row(Modifier.background(LocalPalette.current.raised)) {
                for (column in grid.columns) Heading(statistics, grid, column)
            }
            HorizontalDivider(Modifier.width(width))
            LazyColumn(Modifier.width(width).weight(1f), down) {
                items(grid.rows) { row -> RecordingRow(grid, row, isOpen = row.path == open) { onOpen(row.path) } }
            }
        }
        VerticalScrollbar(rememberScrollbarAdapter(down), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        HorizontalScrollbar(rememberScrollbarAdapter(across), Modifier.align(Alignment.BottomStart).fillMaxWidth())
    }
}

@Composable
private fun Heading(statistics: SelectedStatistics, grid: StatisticsGrid, column: StatisticsColumn) {
    val choice = statistics.state
    val name = nameOf(column)
    Tip("Sort by $name") {
        Row(
            Modifier
                .width(widthOf(column))
                .clickable { statistics.change { sortedBy(column) } }
                .semantics { contentDescription = "Sort by $name" }
                .padding(horizontal = 10.dp, vertical = 5.dp),
            Arrangement.spacedBy(4.dp),
            Alignment.Bottom,
        ) {
            Column(Modifier.weight(1f)) {
                if (column is FigureColumn) HeadingText(grid.nameOf(column), isFigure = true, isSecond = true)
                val unit = (column as? FigureColumn)?.let { grid.unitOf(it) } ?: Topic.UNITLESS
                val title = (column as? FigureColumn)?.statistic?.title ?: name
                HeadingText(if (Units.isNone(unit)) title else "$title ($unit)", isFigure = column is FigureColumn, isSecond = false)
            }
            if (choice.sort == column) {
                Icon(if (choice.isDescending) Icons.Down else Icons.Up, contentDescription = null, Modifier.size(14.dp))
            }
        }
    }
}

@Composable
private fun HeadingText(text: String, isFigure: Boolean, isSecond: Boolean) {
    val palette = LocalPalette.current
    NameText(
        text,
        Modifier.fillMaxWidth(),
        color = if (isSecond) palette.muted else palette.text,
        fontSize = if (isSecond) 11.sp else 13.sp,
        fontWeight = if (isSecond) null else FontWeight.SemiBold,
        textAlign = if (isFigure) TextAlign.End else TextAlign.Start,
    )
}

@Composable
private fun RecordingRow(grid: StatisticsGrid, row: StatisticsRow, isOpen: Boolean, onOpen: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .combinedClickable(onDoubleClick = onOpen) {}
            .semantics { contentDescription = "Log ${row.label}" },
    ) {
        for (column in grid.columns) {
            val background = when {
                column !is FigureColumn -> Color.Transparent
                grid.isLowest(column, row) -> palette.warningSoft
                grid.isHighest(column, row) -> palette.accentSoft
                else -> Color.Transparent
            }
            val text = grid.textOf(column, row)
            val place = Modifier.width(widthOf(column)).background(background).padding(horizontal = 10.dp, vertical = 5.dp)
            if (column == LabelColumn) {
                NameText(text, place, fontWeight = if (isOpen) FontWeight.SemiBold else null, cut = NameCut.MIDDLE)
            } else {
                val align = if (column is FigureColumn) TextAlign.End else TextAlign.Start
                Text(text, place, textAlign = align, maxLines = 1, overflow = TextOverflow.Ellipsis)
            }
        }
    }
}

private fun nameOf(column: StatisticsColumn) = when (column) {
    LabelColumn -> "Log"
    DateColumn -> "Date"
    is FigureColumn -> "${column.topic} ${column.statistic.title}"
}

private fun widthOf(column: StatisticsColumn): Dp = when (column) {
    LabelColumn -> 300.dp
    DateColumn -> 170.dp
    is FigureColumn -> 120.dp
}
