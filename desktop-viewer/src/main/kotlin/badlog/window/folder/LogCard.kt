package badlog.window.folder

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.text.withStyle
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.panel.Cell
import badlog.viewer.panel.Check
import badlog.viewer.panel.Table
import badlog.viewer.panel.TableRow
import badlog.viewer.panel.folder.PREVIEW
import badlog.viewer.shown.folder.LogColumn
import badlog.viewer.state.Action
import badlog.window.findings.findingColor
import badlog.window.panel.CellView
import badlog.window.panel.CheckView
import badlog.window.panel.PreviewCurve
import badlog.window.panel.ShareBar
import badlog.window.panel.rowColor
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.Tip

/** Shows [row] of [table] in a narrow list: its title, what happened, facts, a preview, and the files of a match with several. */
@Composable
internal fun LogCard(row: TableRow, table: Table, isOpen: Boolean, isSelected: Boolean, send: (Action) -> Unit) {
    val palette = LocalPalette.current
    val interactions = remember { MutableInteractionSource() }
    val isHovered by interactions.collectIsHoveredAsState()
    val cells = table.columns.zip(row.cells) { column, cells -> column.key to cells }.toMap()
    fun of(column: LogColumn) = cells[column.name].orEmpty()
    val facts = FACTS.flatMap { of(it) }
    val files = of(LogColumn.FILE)
    Row(
        Modifier
            .fillMaxWidth()
            .background(rowColor(palette, isOpen || isSelected, isHovered))
            .hoverable(interactions)
            .clickable(onClickLabel = "Open") { row.open?.let(send) }
            .semantics {
                contentDescription = row.name
                selected = isOpen
            },
    ) {
        Column(Modifier.width(28.dp).padding(start = 2.dp, top = 3.dp)) {
            if (files.size < 2) {
                for (check in row.checks) CheckView(check, send)
            }
        }
        Column(Modifier.weight(1f).padding(top = 6.dp, bottom = 6.dp, end = 12.dp)) {
            val color = if (row.isMuted) palette.muted else palette.text
            for (title in of(LogColumn.MATCH)) NameText(title.text, color = color, fontWeight = FontWeight.SemiBold, cut = NameCut.FILE)
            for (cell in of(LogColumn.FINDINGS)) {
                CellView(cell, row.name, color, FontWeight.Normal, isHovered, send)
            }
            Row(horizontalArrangement = Arrangement.spacedBy(6.dp), verticalAlignment = Alignment.CenterVertically) {
                Box(Modifier.weight(1f, fill = false)) { Tip(row.key) { Facts(facts) } }
                for (cell in of(LogColumn.BATTERY)) ShareBar(cell)
            }
            for (cell in cells[PREVIEW].orEmpty()) {
                cell.preview?.let {
                    val line = if (row.isMuted) palette.muted.copy(alpha = 0.5f) else palette.accent
                    PreviewCurve(it, line, Modifier.fillMaxWidth().padding(top = 3.dp).height(16.dp))
                }
            }
            if (files.size > 1) files.forEachIndexed { i, file -> FileLine(file, row.checks.getOrNull(i), send) }
        }
    }
}

@Composable
private fun FileLine(file: Cell, check: Check?, send: (Action) -> Unit) {
    val press = file.open?.let { open -> Modifier.clickable { send(open) } } ?: Modifier
    Row(verticalAlignment = Alignment.CenterVertically) {
        if (check != null) CheckView(check, send)
        NameText(file.text, press, LocalPalette.current.muted, fontSize = 12.sp, cut = NameCut.FILE)
    }
}

@Composable
private fun Facts(cells: List<Cell>) {
    val palette = LocalPalette.current
    val text = buildAnnotatedString {
        cells.forEachIndexed { i, cell ->
            if (i > 0) append(" · ")
            withStyle(SpanStyle(cell.severity?.let(palette::findingColor) ?: palette.muted)) { append(cell.text) }
        }
    }
    Text(text, color = palette.muted, fontSize = 12.sp, lineHeight = 16.sp, maxLines = 1, overflow = TextOverflow.Ellipsis)
}

private val FACTS = listOf(LogColumn.DATE, LogColumn.DURATION, LogColumn.BATTERY, LogColumn.PROBLEMS, LogColumn.ALLIANCE)
