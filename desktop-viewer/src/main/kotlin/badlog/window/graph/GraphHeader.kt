package badlog.window.graph

import androidx.compose.foundation.clickable
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.layout.Placeable
import androidx.compose.ui.layout.SubcomposeLayout
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.text.withStyle
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.isTitledByPath
import badlog.viewer.shown.comparison.shortLabel
import badlog.viewer.shown.cursor.comparisonText
import badlog.viewer.shown.statistics.textOf
import badlog.viewer.state.GraphChange
import badlog.viewer.text.countText
import badlog.viewer.text.exactText
import badlog.viewer.text.numberText
import badlog.viewer.text.unitText
import badlog.window.graph.plot.DrawnLine
import badlog.window.graph.plot.PlotPicture
import badlog.window.graph.plot.drawnLines
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.xy.XyLegend
import badlog.window.log.valueText
import badlog.window.menu.MenuBox
import badlog.window.theme.Icons
import badlog.window.theme.LineColor
import badlog.window.theme.LineName
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.Tip
import java.awt.Cursor

/** The title and legend of a graph, in at most [maxLines] lines of text; the rest is in a menu. */
@Composable
internal fun GraphHeader(scene: GraphScene, spec: BoardGraph, maxLines: Int, modifier: Modifier) {
    val lines = remember(spec, scene.recordings) { drawnLines(spec, scene.recordings) }
    val room = modifier.fillMaxWidth().heightIn(min = (GraphScene.HEADER_HEIGHT - 2).dp).padding(start = 10.dp, end = MENU_ROOM, top = 2.dp)
    if (spec.isXy) {
        FlowRow(room, Arrangement.spacedBy(14.dp), itemVerticalAlignment = Alignment.CenterVertically, maxLines = maxLines) {
            GraphTitle(scene, spec)
            XyLegend(scene, spec)
        }
        return
    }
    // A graph with a single signal has the signal's name.
    val isAlone = lines.distinctBy { it.signal.name }.size == 1 && lines.first().signal.name.endsWith(plain(spec.title))
    LegendFlow(
        count = maxOf(lines.size, 1),
        maxLines,
        room,
        title = { GraphTitle(scene, spec) },
        // A line may already be gone before the next layout.
        entry = { i -> lines.getOrNull(i)?.let { LegendEntry(scene, spec, it, hasName = !isAlone) } ?: NoLines(lines) },
        more = { first -> MoreLines(scene, spec, lines.drop(first)) },
    )
}

@Composable
private fun NoLines(lines: List<DrawnLine>) {
    if (lines.isEmpty()) Text("not in this log", color = LocalPalette.current.muted, fontSize = 12.sp)
}

/** The button for [lines] that do not fit in the header of [spec]; a click lists them. */
@Composable
private fun MoreLines(scene: GraphScene, spec: BoardGraph, lines: List<DrawnLine>) {
    var isOpen by remember { mutableStateOf(false) }
    val list = @Composable {
        Column(Modifier.padding(horizontal = 12.dp), Arrangement.spacedBy(3.dp)) {
            for (line in lines) LegendEntry(scene, spec, line, hasName = true)
        }
    }
    MenuBox(isOpen, { isOpen = false }, menu = list) {
        Text(
            "+${lines.size}",
            Modifier
                .clickable(role = Role.Button) { isOpen = !isOpen }
                .semantics { contentDescription = "${countText(lines.size, "more line")} of ${scene.board.titleOf(spec)}" }
                .padding(horizontal = 4.dp),
            color = LocalPalette.current.accent,
            fontSize = 12.sp,
            maxLines = 1,
        )
    }
}

@Composable
private fun GraphTitle(scene: GraphScene, spec: BoardGraph) {
    val palette = LocalPalette.current
    val title = scene.board.titleOf(spec)
    val cut = if (spec.isTitledByPath) title.lastIndexOf('/') else -1
    val folder = title.take(maxOf(cut, 0)).takeLast(MAX_FOLDER_LETTERS)
    Row(Modifier.pointerHoverIcon(PointerIcon(Cursor(Cursor.MOVE_CURSOR)))) {
        NameText(
            buildAnnotatedString {
                if (folder.isNotEmpty()) withStyle(SpanStyle(color = palette.muted)) { append("$folder / ") }
                withStyle(SpanStyle(fontWeight = FontWeight.Medium)) { append(title.substring(cut + 1)) }
            },
            Modifier.widthIn(max = 420.dp),
        )
    }
}

/** Returns [title] without its folders, and without the brackets of a calculated topic. */
private fun plain(title: String) = title.substringAfterLast('/').removePrefix("[ ").removeSuffix(" ]")

private const val MAX_FOLDER_LETTERS = 60

/** The room for a graph's menu beside its legend. */
private val MENU_ROOM = 42.dp

/** A line's color, its name if [hasName], and its value under the cursor. */
@Composable
internal fun LegendEntry(scene: GraphScene, spec: BoardGraph, line: DrawnLine, hasName: Boolean) {
    val palette = LocalPalette.current
    val interactions = remember { MutableInteractionSource() }
    val isHovered by interactions.collectIsHoveredAsState()
    val isHidden = line.signal.name in spec.hidden
    val toggle = { scene.board.send(GraphChange.HideLines(spec.id, listOf(line.signal.name), !isHidden)) }
    val toggled = if (spec.lines.size > 1) {
        Modifier.clickable(role = Role.Button, onClick = toggle)
            .semantics { contentDescription = if (isHidden) "Show ${line.title}" else "Hide ${line.title}" }
    } else {
        Modifier
    }
    Row(
        toggled.hoverable(interactions),
        horizontalArrangement = Arrangement.spacedBy(5.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        if (line.signal.states == null) LineColor(line.color, isHidden)
        val name = listOfNotNull(line.title.takeIf { hasName }, line.label?.let { shortLabel(it, LABEL_LETTERS) }).joinToString(" · ")
        if (name.isNotEmpty()) LineName(name, isHidden)
        Tip({ tipText(scene, spec.id, line) }) { LegendValue(scene, spec.id, line) }
        if (isHovered && hasName && spec.lines.size > 1) {
            Icon(
                Icons.Close,
                "Remove ${line.title}",
                Modifier.size(12.dp).clickable {
                    scene.board.send(GraphChange.RemoveLine(spec.id, line.signal.name))
                },
                palette.muted,
            )
        }
    }
}

/** Returns the value of [line] with all digits, or the time in each of its states. */
private fun tipText(scene: GraphScene, id: Int, line: DrawnLine): String {
    if (line.signal.states != null) return statesText(scene, line)
    return readingOf(scene.pictureOf(scene.plots.state(id)), line, scene.view.cursor, scene.view.secondCursor, ::exactText)
}

/** Returns the time and count of each state of [line] in the visible range, or between the cursors. */
private fun statesText(scene: GraphScene, line: DrawnLine): String {
    val span = scene.view.cursors.between ?: scene.view.viewport.visible
    val there = Span(span.from - line.offset, span.to - line.offset)
    return scene.plots.curves.runs(line.recording, line.signal).textOf(line.signal.states.orEmpty(), there, line.recording.view.xAxis)
}

/** The value of [line] under the cursor. It is drawn without layout, because the cursor moves as fast as the mouse. */
@Composable
private fun LegendValue(scene: GraphScene, id: Int, line: DrawnLine) {
    val palette = LocalPalette.current
    val letters = rememberTextMeasurer()
    val style = remember(palette) { TextStyle(color = palette.text, fontSize = 12.sp, fontWeight = FontWeight.Medium) }
    val unit = remember(palette) { TextStyle(color = palette.muted, fontSize = 12.sp) }
    Spacer(
        Modifier.width(valueWidth(line, isComparing = scene.view.secondCursor != null)).height(17.dp).drawBehind {
            val picture = scene.pictureOf(scene.plots.state(id))
            val text = readingOf(picture, line, scene.view.cursor, scene.view.secondCursor)
            val layout = letters.measure(
                text.ifEmpty { picture?.legendOf(line) ?: unitText(line.signal.unit) },
                if (text.isEmpty()) unit else style,
                TextOverflow.Ellipsis,
                softWrap = false,
                maxLines = 1,
                Constraints(maxWidth = size.width.toInt()),
            )
            drawText(layout, topLeft = Offset(0f, (size.height - layout.size.height) / 2))
        },
    )
}

/** Returns the text beside [line] without a cursor: its unit, and its axis unless it is the left one. */
private fun PlotPicture.legendOf(line: DrawnLine): String? =
    plot.lines.getOrNull(lines.indexOf(line))?.let { drawn -> plot.axes[drawn.axis].run { side.legendOf(unit) } }

private fun valueWidth(line: DrawnLine, isComparing: Boolean) = when {
    isComparing -> if (line.signal.states == null) 330.dp else 180.dp
    line.signal.states == null -> 104.dp
    else -> 84.dp
}

/**
 * Returns the value of [line] at the [cursor], formatted by [sampleText]; with a [second] cursor, both values compared. It is empty without
 * a cursor, and until [picture] has the line.
 */
internal fun readingOf(
    picture: PlotPicture?,
    line: DrawnLine,
    cursor: Double?,
    second: Double? = null,
    sampleText: (Double) -> String = ::numberText,
): String {
    if (picture == null || cursor == null || line !in picture) return ""
    val a = cursor - line.offset
    if (second == null) return valueText(line.signal, a, sampleText)
    return line.signal.line.comparisonText(a, second - line.offset, line.recording.view.xAxis.unit, sampleText)
}

/** The largest length of a recording's name; a longer one would leave no room for others. */
private const val LABEL_LETTERS = 28

/**
 * Places [title] and then [count] entries from left to right, in at most [maxLines] lines. If some do not fit, [more] follows the
 * others, and receives the index of the first missing one.
 */
@Composable
internal fun LegendFlow(
    count: Int,
    maxLines: Int,
    modifier: Modifier = Modifier,
    title: @Composable () -> Unit,
    entry: @Composable (Int) -> Unit,
    more: @Composable (first: Int) -> Unit,
) {
    SubcomposeLayout(modifier) { constraints ->
        val gap = GAP.roundToPx()
        val reserve = gap + MORE_WIDTH.roundToPx()
        val width = constraints.maxWidth
        val loose = Constraints(maxWidth = maxOf(0, width - reserve))

        fun measured(key: Any, content: @Composable () -> Unit) = subcompose(key, content).firstOrNull()?.measure(loose)
        val lines = arrayListOf(ArrayList<Placeable>())
        measured("title", title)?.let { lines.last().add(it) }
        var shown = 0
        while (shown < count) {
            val index = shown
            val placeable = measured(index) { entry(index) } ?: break
            val isLastLine = lines.size == maxLines
            val room = if (isLastLine && index < count - 1) width - reserve else width
            val used = lines.last().sumOf { it.width + gap }
            if (lines.last().isNotEmpty() && used + placeable.width > room) {
                if (isLastLine) break
                lines.add(ArrayList())
            }
            lines.last().add(placeable)
            shown++
        }
        val first = shown
        if (first < count) measured("more") { more(first) }?.let { lines.last().add(it) }
        val heights = lines.map { line -> line.maxOfOrNull { it.height } ?: 0 }
        layout(width, heights.sum().coerceIn(constraints.minHeight, constraints.maxHeight)) {
            var top = 0
            lines.forEachIndexed { i, line ->
                var left = 0
                for (placeable in line) {
                    placeable.placeRelative(left, top + (heights[i] - placeable.height) / 2)
                    left += placeable.width + gap
                }
                top += heights[i]
            }
        }
    }
}

private val GAP = 14.dp

/** The room for the button that replaces the missing entries. */
private val MORE_WIDTH = 36.dp
