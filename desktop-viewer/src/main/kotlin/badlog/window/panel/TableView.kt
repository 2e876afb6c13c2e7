package badlog.window.panel

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.panel.Button
import badlog.viewer.panel.Cell
import badlog.viewer.panel.Column
import badlog.viewer.panel.Table
import badlog.viewer.state.Action
import badlog.viewer.text.withUnit
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.Tip

/** Shows [table]: the cells of a row below its subject, side by side if there are few, otherwise each with its title, in two columns. */
@Composable
internal fun TableView(table: Table, send: (Action) -> Unit) {
    val isNarrow = table.columns.size <= MAX_BESIDE
    Column(Modifier.fillMaxWidth().padding(start = 12.dp, end = 14.dp, top = 10.dp)) {
        val columns = table.columns.drop(1)
        val isOne = table.rows.drop(1).all { it.cells.first().isEmpty() }
        if (isNarrow && !isOne) {
            Text(table.columns.first().title, fontWeight = FontWeight.SemiBold)
            Titles(columns, send)
        }
        for (row in table.rows) {
            val subject = row.cells.first()
            val cells = row.cells.drop(1).map { it.firstOrNull() ?: Cell("") }
            Subject(subject, send)
            if (subject.isNotEmpty() && isNarrow && isOne) Titles(columns, send)
            if (isNarrow) {
                Row(verticalAlignment = Alignment.CenterVertically) { for (cell in cells) Value(cell, send, Modifier.weight(1f)) }
            } else {
                for (pair in columns.zip(cells).chunked(2)) {
                    Row(Modifier.fillMaxWidth()) {
                        for ((column, cell) in pair) {
                            Row(Modifier.weight(1f).padding(end = 4.dp)) {
                                Title(column, send, Modifier.width(66.dp))
                                Value(cell, send, Modifier.weight(1f))
                            }
                        }
                    }
                }
            }
        }
    }
}

@Composable
private fun Titles(columns: List<Column>, send: (Action) -> Unit) {
    Row(verticalAlignment = Alignment.CenterVertically) { for (column in columns) Title(column, send, Modifier.weight(1f)) }
}

@Composable
private fun Title(column: Column, send: (Action) -> Unit, modifier: Modifier) {
    val sort = column.sort
    if (sort == null) {
        Tip(column.hint, modifier) { NameText(column.title, color = LocalPalette.current.muted, fontSize = 12.sp, cut = NameCut.MIDDLE) }
    } else {
        Row(modifier) { ButtonsView(listOf(Button(column.title, sort, hint = column.hint, isOn = column.isDescending != null)), send) }
    }
}

/** The subject of a row, and the log it is from if there are several. */
@Composable
private fun Subject(cells: List<Cell>, send: (Action) -> Unit) {
    cells.forEachIndexed { i, cell ->
        Row(horizontalArrangement = Arrangement.spacedBy(6.dp), verticalAlignment = Alignment.CenterVertically) {
            cell.color?.let { Box(Modifier.size(8.dp).background(LocalPalette.current.line(it), RoundedCornerShape(2.dp))) }
            if (i == 0) {
                NameText(cell.text, Modifier.weight(1f), fontWeight = FontWeight.SemiBold)
            } else {
                NameText(cell.text, color = LocalPalette.current.muted, fontSize = 12.sp)
            }
            ButtonsView(cell.tools, send, areIcons = true)
        }
    }
}

@Composable
private fun Value(cell: Cell, send: (Action) -> Unit, modifier: Modifier) {
    cell.open?.let { return Row(modifier) { ButtonsView(listOf(Button(cell.text, it, hint = cell.hint)), send) } }
    // A number that is cut off would be a different one, so two lines are better.
    Tip(withUnit(cell.hint, cell.unit), modifier) { Text(withUnit(cell.text, cell.unit), fontSize = 12.sp, lineHeight = 15.sp) }
}

/** The largest number of columns, including the one of names, that fit beside each other. */
private const val MAX_BESIDE = 5
