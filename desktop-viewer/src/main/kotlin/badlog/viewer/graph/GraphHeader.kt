package badlog.viewer.graph

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.text.withStyle
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.plot.board.BoardGraph
import badlog.viewer.graph.plot.drawnLines
import badlog.viewer.graph.scene.GraphScene
import badlog.viewer.graph.xy.XyLegend
import badlog.viewer.theme.LocalPalette
import java.awt.Cursor

/** What a graph is called, and what its lines are; no more than [maxLines] of text. */
@Composable
internal fun GraphHeader(scene: GraphScene, spec: BoardGraph, maxLines: Int, modifier: Modifier) {
    val lines = remember(spec, scene.recordings) { drawnLines(spec, scene.recordings) }
    FlowRow(
        modifier.fillMaxWidth().heightIn(min = (GraphScene.HEADER_HEIGHT - 2).dp).padding(start = 10.dp, end = 12.dp, top = 2.dp),
        horizontalArrangement = Arrangement.spacedBy(14.dp),
        itemVerticalAlignment = Alignment.CenterVertically,
        maxLines = maxLines,
    ) {
        GraphTitle(spec.title)
        if (spec.isXy) {
            XyLegend(scene, spec)
            return@FlowRow
        }
        // The only signal of a graph is what the graph is called.
        val isAlone = lines.distinctBy { it.signal.name }.size == 1 && lines.first().signal.name.endsWith(plain(spec.title))
        for (line in lines.take(MAX_ENTRIES)) {
            LegendEntry(scene, spec, line, hasName = !isAlone)
        }
        if (lines.isEmpty()) Text("not in this log", color = LocalPalette.current.muted, fontSize = 12.sp)
        if (lines.size > MAX_ENTRIES) {
            Text("and ${lines.size - MAX_ENTRIES} more", color = LocalPalette.current.muted, fontSize = 12.sp)
        }
    }
}

@Composable
private fun GraphTitle(title: String) {
    val palette = LocalPalette.current
    val folder = title.substringBeforeLast('/', "").takeLast(MAX_FOLDER_LETTERS)
    Row(Modifier.pointerHoverIcon(PointerIcon(Cursor(Cursor.MOVE_CURSOR)))) {
        Text(
            buildAnnotatedString {
                if (folder.isNotEmpty()) withStyle(SpanStyle(color = palette.muted)) { append("$folder / ") }
                withStyle(SpanStyle(fontWeight = FontWeight.Medium)) { append(title.substringAfterLast('/')) }
            },
            Modifier.widthIn(max = 420.dp),
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
    }
}

/** A title as the signal's name has it. */
private fun plain(title: String) = title.substringAfterLast('/').removePrefix("[ ").removeSuffix(" ]")

private const val MAX_ENTRIES = 24
private const val MAX_FOLDER_LETTERS = 60
