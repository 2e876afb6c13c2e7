package badlog.window.panel

import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.core.recording.Severity
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.Field
import badlog.viewer.panel.Fold
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Line
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.Rows
import badlog.viewer.state.Action
import badlog.viewer.text.word
import badlog.window.findings.findingColor
import badlog.window.findings.findingSoft
import badlog.window.menu.ContextArea
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.viewer.panel.Row as PanelRow

/** Shows [row]: in a frame if its lines belong together, otherwise its severity and times beside its text. */
@Composable
internal fun RowView(row: PanelRow, send: (Action) -> Unit) {
    if (row.isFramed) return FramedRow(row, send)
    if (row.menu.isEmpty()) return PlainRow(row, send)
    ContextArea({ row.menu.map { ContextMenuItem(it.label) { send(it.action) } } }) { PlainRow(row, send) }
}

@Composable
private fun PlainRow(row: PanelRow, send: (Action) -> Unit) {
    Row(
        Modifier.inspectorLine(row.name, row.isCurrent, gap = 5.dp) { row.open?.let(send) },
        horizontalArrangement = Arrangement.spacedBy(8.dp),
    ) {
        row.check?.let { CheckView(it, send) }
        if (row.severity != null || row.lines.isNotEmpty()) {
            Column(Modifier.width(62.dp)) {
                row.severity?.let { SeverityBadge(it, it.word) }
                for (line in row.lines) {
                    line.since?.let { Time(it) }
                    Time(line.time)
                }
            }
        }
        Column(Modifier.weight(1f)) {
            if (row.title.isNotEmpty()) NameText(row.title, fontWeight = FontWeight.Medium, cut = NameCut.MIDDLE)
            // A finding's text is always whole.
            val lines = if (row.severity == null) MAX_LINES else Int.MAX_VALUE
            for (line in row.lines) Text(line.text, maxLines = lines, overflow = TextOverflow.Ellipsis)
            if (row.count.isNotEmpty()) Text(row.count, color = LocalPalette.current.muted, fontSize = 12.sp)
            BelowRow(row.below, send)
        }
        ButtonsView(row.tools, send, areIcons = true)
    }
}

/** The largest number of lines of a long text, for example of a stack trace. */
private const val MAX_LINES = 8

/** Shows [word] in the colors of [severity]. */
@Composable
internal fun SeverityBadge(severity: Severity, word: String) {
    val palette = LocalPalette.current
    Text(
        word,
        Modifier
            .fillMaxWidth()
            .background(palette.findingSoft(severity), RoundedCornerShape(4.dp))
            .padding(horizontal = 4.dp),
        color = palette.findingColor(severity),
        fontSize = 12.sp,
        textAlign = TextAlign.Center,
    )
}

@Composable
private fun Time(text: String) {
    Text(
        text,
        Modifier.fillMaxWidth(),
        color = LocalPalette.current.muted,
        fontSize = 11.sp,
        textAlign = TextAlign.End,
        maxLines = 1,
        overflow = TextOverflow.Ellipsis,
    )
}

@Composable
private fun FramedRow(row: PanelRow, send: (Action) -> Unit) {
    val palette = LocalPalette.current
    val severity = row.severity ?: Severity.NOTE
    val color = palette.findingColor(severity)
    val shape = RoundedCornerShape(4.dp)
    Column(
        Modifier
            .fillMaxWidth()
            .padding(start = 8.dp, end = 14.dp, top = 3.dp, bottom = 3.dp)
            .background(palette.findingSoft(severity), shape)
            .border(2.dp, if (row.isCurrent) color else Color.Transparent, shape)
            .padding(horizontal = 6.dp, vertical = 4.dp),
    ) {
        Text(
            "${severity.word}: ${row.title}",
            Modifier
                .fillMaxWidth()
                .clickable(role = Role.Button) { row.open?.let(send) }
                .semantics {
                    contentDescription = row.name
                    selected = row.isCurrent
                },
            color = color,
            fontWeight = FontWeight.Medium,
        )
        for (line in row.lines) FramedLine(line, send)
        BelowRow(row.below, send)
    }
}

@Composable
private fun FramedLine(line: Line, send: (Action) -> Unit) {
    Row(
        Modifier
            .fillMaxWidth()
            .clickable(role = Role.Button) { line.open?.let(send) }
            .semantics {
                contentDescription = line.name
                selected = line.isCurrent
            }
            .padding(vertical = 2.dp),
        Arrangement.spacedBy(6.dp),
    ) {
        Text(line.time, color = LocalPalette.current.muted, fontSize = 11.sp)
        Text(line.text, Modifier.weight(1f))
    }
}

/** Shows the parts below the text of a row. */
@Composable
private fun BelowRow(parts: List<Part>, send: (Action) -> Unit) {
    for (part in parts) {
        when (part) {
            is Paragraph -> ToneText(part, Modifier.fillMaxWidth())
            is Buttons -> FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp)) { ButtonsView(part.buttons, send) }
            else -> PartView(part, send)
        }
    }
}

/** Makes an element a clickable line of a list, called [name], with [gap] above and below. */
@Composable
internal fun Modifier.inspectorLine(name: String, isSelected: Boolean, gap: Dp, onClick: () -> Unit): Modifier = fillMaxWidth()
    .background(if (isSelected) LocalPalette.current.accentSoft else Color.Transparent)
    .clickable(onClick = onClick)
    .semantics(mergeDescendants = true) {
        contentDescription = name
        selected = isSelected
    }
    .padding(start = 12.dp, end = 14.dp, top = gap, bottom = gap)

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
