package badlog.window.panel

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.EntryTable
import badlog.viewer.panel.Field
import badlog.viewer.panel.Fold
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.Row
import badlog.viewer.panel.Rows
import badlog.viewer.state.Action

/**
 * Shows a panel that consists of [parts]: heading, paragraphs, buttons and fields at its beginning stay above the others, which scroll.
 * A table at its end scrolls below all others.
 *
 * @param goal the row that a person went to; the panel scrolls to the current row when it changes.
 */
@Composable
internal fun PanelView(parts: List<Part>, goal: Any?, send: (Action) -> Unit, modifier: Modifier) {
    val table = parts.lastOrNull()
    if (table is EntryTable) {
        Column(modifier) {
            for (part in parts.dropLast(1)) PartView(part, send)
            Box(Modifier.weight(1f)) { EntryTableView(table, send) }
        }
        return
    }
    val (above, below) = remember(parts) {
        fun stays(part: Part) = part is Heading || part is Paragraph || part is Buttons || part is Field
        parts.takeWhile(::stays) to parts.dropWhile(::stays).flatMap(::flat)
    }
    val state = rememberLazyListState()
    val current = below.mapIndexedNotNull { i, cell -> i.takeIf { (cell.part as? Row)?.isCurrent == true } }
    LaunchedEffect(goal) {
        if (current.isEmpty()) return@LaunchedEffect
        // The height of the rows below is known only after layout.
        withFrameNanos { }
        // Somebody who goes to a finding of an incident reads the incident, unless it was chosen among the findings below.
        val isRead = state.layoutInfo.visibleItemsInfo.any { it.index == current.last() }
        if (current.size == 1 || !isRead) showWhole(state, current.first())
    }
    Column(modifier) {
        for (part in above) PartView(part, send)
        Box(Modifier.weight(1f)) {
            LazyColumn(Modifier.fillMaxSize(), state) {
                items(below, key = { it.key }) { PartView(it.part, send) }
            }
            VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

/** A [part] of a list that scrolls, with a key that no other part of the list has. */
private class Cell(val key: String, val part: Part)

private fun flat(part: Part): List<Cell> = when {
    part is Rows -> part.rows.map { Cell("${part.key}\u0000${it.key}", it) }

    part is Fold -> listOf(Cell(part.key, part)) + if (part.isOpen) {
        part.parts.flatMap(::flat).map { Cell("${part.key}\u0000${it.key}", it.part) }
    } else {
        emptyList()
    }

    else -> listOf(Cell(part.key, part))
}

/** Scrolls [list] until all of item [index] is visible; if it is higher than the list, its start. */
private suspend fun showWhole(list: LazyListState, index: Int) {
    val seen = list.layoutInfo.visibleItemsInfo
    if (seen.none { it.index == index }) list.scrollToItem(maxOf(0, index - seen.size / 2))
    val layout = list.layoutInfo
    val item = layout.visibleItemsInfo.firstOrNull { it.index == index }
    if (item == null || item.offset < layout.viewportStartOffset) {
        list.scrollToItem(index)
    } else if (item.offset + item.size > layout.viewportEndOffset) {
        list.scrollToItem(index, minOf(0, item.size - (layout.viewportEndOffset - layout.viewportStartOffset)))
    }
}
