package badlog.window.panel

import androidx.compose.foundation.HorizontalScrollbar
import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.gestures.detectTapGestures
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListScope
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.panel.Cell
import badlog.viewer.panel.Extreme
import badlog.viewer.panel.RowGroup
import badlog.viewer.panel.Table
import badlog.viewer.panel.TableRow
import badlog.viewer.state.Action
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.Palette
import badlog.window.theme.Tip
import badlog.viewer.panel.Column as PanelColumn

/**
 * Shows [table] in a place that is wide enough for its columns; its rows scroll below its titles.
 *
 * @param selected the key of the selected row; null for none.
 * @param open the key of the row with the open log; null for none.
 * @param onSelect called with the row that a person presses; null if a press opens the row.
 */
@Composable
internal fun WideTableView(
    table: Table,
    send: (Action) -> Unit,
    list: LazyListState = rememberLazyListState(),
    selected: String? = null,
    open: String? = null,
    onSelect: ((TableRow) -> Unit)? = null,
) {
    val sideways = rememberScrollState()
    BoxWithConstraints(Modifier.fillMaxSize()) {
        val fitting = remember(table, maxWidth) { if (widthOf(table) > maxWidth) table.withoutMinor() else table }
        val widths = remember(fitting, maxWidth) { widthsOf(fitting, maxWidth) }
        Column(Modifier.fillMaxSize().horizontalScroll(sideways).width(widths.checks + widths.columns.reduce(Dp::plus))) {
            TableHead(fitting, widths, send)
            HorizontalDivider()
            LazyColumn(Modifier.weight(1f).padding(bottom = 8.dp), list) {
                rows(fitting) { row ->
                    RowOfCells(row, fitting, widths, row.key == open, row.key == selected, onSelect?.let { { it(row) } }, send)
                }
            }
        }
        VerticalScrollbar(rememberScrollbarAdapter(list), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        HorizontalScrollbar(rememberScrollbarAdapter(sideways), Modifier.align(Alignment.BottomCenter).fillMaxWidth())
    }
}

/** Adds the groups of [table] to a list, with their titles. */
internal fun LazyListScope.rows(table: Table, row: @Composable (TableRow) -> Unit) {
    for (group in table.groups) {
        if (group.title.isNotEmpty()) item("group ${group.title}") { GroupTitle(group) }
        items(group.rows, key = { it.key }) { row(it) }
    }
}

/** The widths of the check boxes, and of each column. */
private class TableWidths(val checks: Dp, val columns: List<Dp>)

/**
 * Returns the widths in [table], in the width [available]. More room is shared in proportion; if there is less, long texts are cut.
 */
private fun widthsOf(table: Table, available: Dp): TableWidths {
    val checks = checksOf(table)
    val room = (available - checks).value
    val needed = neededBy(table)
    val excess = needed.sum() - room
    if (excess <= 0) return TableWidths(checks, needed.map { (it * room / needed.sum()).dp })
    val spare = needed.map { maxOf(0f, it - FEW_LETTERS * LETTER) }
    val cut = minOf(1f, excess / spare.sum())
    return TableWidths(checks, needed.zip(spare) { width, part -> (width - part * cut).dp })
}

private fun widthOf(table: Table): Dp = checksOf(table) + neededBy(table).sum().dp

private fun checksOf(table: Table): Dp = if (table.rows.any { it.checks.isNotEmpty() }) 34.dp else 0.dp

/** Returns the width of each column of [table] that has room for its texts, in dp. */
private fun neededBy(table: Table): List<Float> {
    val rows = table.rows
    return table.columns.mapIndexed { i, column ->
        val letters = rows.maxOfOrNull { row -> row.cells[i].maxOfOrNull(::lettersOf) ?: 0 } ?: 0
        maxOf(column.title.lines().maxOf { it.length } + 2, letters.coerceAtMost(MAX_LETTERS)) * (if (column.isNumber) DIGIT else LETTER) +
            2 * GAP
    }
}

private fun lettersOf(cell: Cell) = cell.text.length + when {
    cell.preview != null -> PREVIEW_LETTERS
    cell.share != null || cell.severity != null -> MARK_LETTERS
    else -> 0
}

/** The titles of the columns of [table]; a click sorts. */
@Composable
private fun TableHead(table: Table, widths: TableWidths, send: (Action) -> Unit) {
    val palette = LocalPalette.current
    Row(Modifier.fillMaxWidth().background(palette.raised).padding(start = widths.checks)) {
        table.columns.forEachIndexed { i, column ->
            val sort = column.sort
            val sorts = if (sort == null) {
                Modifier
            } else {
                Modifier
                    .clickable(role = Role.Button) { send(sort) }
                    .focusProperties { canFocus = false }
                    .semantics { contentDescription = "Sort by ${column.hint.ifEmpty { column.title }}" }
            }
            Row(
                Modifier.width(widths.columns[i]).then(sorts).padding(horizontal = GAP.dp, vertical = 6.dp),
                column.arrangement,
                Alignment.CenterVertically,
            ) {
                val isDescending = column.isDescending
                val color = if (isDescending != null) palette.accent else palette.muted
                Tip(column.hint) {
                    Column(horizontalAlignment = if (column.isNumber) Alignment.End else Alignment.Start) {
                        for (line in column.title.lines()) NameText(line, color = color, fontSize = 12.sp, fontWeight = FontWeight.SemiBold)
                    }
                }
                if (isDescending != null) Icon(if (isDescending) Icons.Down else Icons.Up, null, Modifier.size(12.dp), color)
            }
        }
    }
}

/** The title of [group], with its count. */
@Composable
private fun GroupTitle(group: RowGroup) {
    Row(Modifier.fillMaxWidth().padding(start = 12.dp, end = 12.dp, top = 10.dp, bottom = 4.dp), Arrangement.spacedBy(8.dp)) {
        Text(
            group.title,
            Modifier.weight(1f, fill = false),
            fontWeight = FontWeight.SemiBold,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
        Text(group.count, color = LocalPalette.current.muted, maxLines = 1)
    }
}

/** Shows [row] of [table]. A press selects it and a double click opens it; without [onSelect], a press opens it. */
@Composable
private fun RowOfCells(
    row: TableRow,
    table: Table,
    widths: TableWidths,
    isOpen: Boolean,
    isSelected: Boolean,
    onSelect: (() -> Unit)?,
    send: (Action) -> Unit,
) {
    val palette = LocalPalette.current
    val interactions = remember { MutableInteractionSource() }
    val isHovered by interactions.collectIsHoveredAsState()
    Row(
        Modifier
            .fillMaxWidth()
            .background(rowColor(palette, isSelected, isHovered))
            .hoverable(interactions)
            .then(if (onSelect == null) pressed(row, table, send) else selectable(row, isSelected, onSelect, send)),
    ) {
        Column(Modifier.width(widths.checks).padding(start = 4.dp)) {
            for (check in row.checks) LineOf(Arrangement.Start) { CheckView(check, send) }
        }
        table.columns.forEachIndexed { i, column ->
            Column(Modifier.width(widths.columns[i]).padding(horizontal = GAP.dp)) {
                for (cell in row.cells[i]) {
                    LineOf(column.arrangement, cell.extreme) {
                        val color = if (row.isMuted) {
                            palette.muted
                        } else if (isOpen) {
                            palette.accent
                        } else {
                            palette.text
                        }
                        val weight = if (i == 0) FontWeight.SemiBold else FontWeight.Normal
                        // A press on the title has the effect of one beside it.
                        CellView(cell, row.name, color, weight, isHovered, send, cell.open.takeIf { i > 0 }, takesFocus = onSelect == null)
                    }
                }
            }
        }
    }
}

@Composable
private fun selectable(row: TableRow, isSelected: Boolean, onSelect: () -> Unit, send: (Action) -> Unit): Modifier {
    val select by rememberUpdatedState(onSelect)
    val open by rememberUpdatedState { row.open?.let(send) ?: Unit }
    return Modifier
        .pointerInput(Unit) { detectTapGestures(onPress = { select() }, onDoubleTap = { open() }) }
        .semantics {
            contentDescription = row.name
            selected = isSelected
            onClick("Open") {
                open()
                true
            }
        }
}

private fun pressed(row: TableRow, table: Table, send: (Action) -> Unit): Modifier {
    // The name alone would hide the row's texts from screen readers.
    val texts = table.columns.zip(row.cells).drop(1).flatMap { (column, cells) -> cells.map { "${column.title} ${it.text}" } }
    val fold = row.cells[0].firstOrNull()?.isUnfolded?.let { if (it) "unfolded" else "folded" }
    val named = Modifier.semantics {
        contentDescription = row.name
        stateDescription = (listOfNotNull(fold) + texts).joinToString()
    }
    return row.open?.let { Modifier.clickable(role = Role.Button) { send(it) }.then(named) } ?: named
}

@Composable
private fun LineOf(arrangement: Arrangement.Horizontal, extreme: Extreme? = null, content: @Composable () -> Unit) {
    val color = extreme?.let { extremeColor(it, LocalPalette.current) } ?: Color.Transparent
    Row(Modifier.fillMaxWidth().height(28.dp).background(color), arrangement, Alignment.CenterVertically) { content() }
}

/** Returns the color behind the [extreme] of a column. */
internal fun extremeColor(extreme: Extreme, palette: Palette): Color = when (extreme) {
    Extreme.SMALLEST -> palette.warningSoft
    Extreme.LARGEST -> palette.accentSoft
}

private val PanelColumn.arrangement: Arrangement.Horizontal get() = if (isNumber) Arrangement.End else Arrangement.Start

/** The width of a letter, in dp. */
private const val LETTER = 7.5f

/** The width of a digit, in dp. */
private const val DIGIT = 8.2f

/** The space beside a text, in dp. */
private const val GAP = 8

/** The maximum number of letters in a column, unless there is room for more. */
private const val MAX_LETTERS = 44

/** The number of letters that remain of a text when there is no room. */
private const val FEW_LETTERS = 24

private const val PREVIEW_LETTERS = 18
private const val MARK_LETTERS = 10
