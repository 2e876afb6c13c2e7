package badlog.window.panel

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.Field
import badlog.viewer.panel.Fold
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.Rows
import badlog.viewer.state.Action

/**
 * Shows a panel that consists of [parts]: heading, paragraphs, buttons and fields at its beginning stay above the others, which scroll.
 *
 * @param goal the row that a person went to; the panel scrolls to the current row when it changes.
 */
@Composable
internal fun PanelView(parts: List<Part>, goal: Any?, send: (Action) -> Unit, modifier: Modifier) {
    val (above, below) = remember(parts) {
        fun stays(part: Part) = part is Heading || part is Paragraph || part is Buttons || part is Field
        parts.takeWhile(::stays) to parts.dropWhile(::stays).flatMap(::blocksOf)
    }
    val state = rememberLazyListState()
    val starts = below.runningFold(0) { sum, block -> sum + block.parts.size }
    val current = below.zip(starts) { block, start -> (start + block.current).takeIf { block.current >= 0 } }.filterNotNull()
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
                for (block in below) {
                    items(block.parts.size, key = { "${block.key}\u0000${block.parts[it].key}" }) { PartView(block.parts[it], send) }
                }
            }
            VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

/** The [parts] of a list that scrolls, with a [key] of their own; [current] is the index of the current one, or -1. */
private class Block(val key: String, val parts: List<Part>, val current: Int = -1)

private fun blocksOf(part: Part): List<Block> = when (part) {
    is Rows -> listOf(Block(part.key, part.rows, part.current))
    is Fold -> listOf(Block("", listOf(part))) + if (part.isOpen) part.parts.flatMap(::blocksOf).map { it.within(part) } else emptyList()
    else -> listOf(Block("", listOf(part)))
}

private fun Block.within(fold: Fold) = Block("${fold.key}\u0000$key", parts, current)

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
