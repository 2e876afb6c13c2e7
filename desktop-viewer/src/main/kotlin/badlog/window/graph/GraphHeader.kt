package badlog.window.graph

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.withStyle
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.isTitledByPath
import badlog.viewer.text.countText
import badlog.window.graph.plot.DrawnLine
import badlog.window.graph.plot.drawnLines
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.xy.XyLegend
import badlog.window.menu.MenuBox
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
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
