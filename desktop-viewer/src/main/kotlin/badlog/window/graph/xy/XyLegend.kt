package badlog.window.graph.xy

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.path.XyEntry
import badlog.viewer.shown.comparison.shortLabel
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.GraphChange
import badlog.window.graph.scene.GraphScene
import badlog.window.theme.LineColor
import badlog.window.theme.LineName
import badlog.window.theme.LocalPalette

/** The traces of [spec], each with its place at the cursor. */
@Composable
internal fun XyLegend(scene: GraphScene, spec: BoardGraph) {
    val recordings = scene.recordings
    val picture = remember(spec.lines, spec.origin, recordings) { xyPictureOf(spec, recordings) }
    if (picture.isEmpty) Text("not in this log", color = LocalPalette.current.muted, fontSize = 12.sp)
    for (part in picture.parts) for (entry in part.entries.take(MAX_ENTRIES)) EntryOfTrace(scene, spec, entry)
}

@Composable
private fun EntryOfTrace(scene: GraphScene, spec: BoardGraph, entry: XyEntry) {
    val isHidden = !entry.isShown(spec.hidden)
    val toggle = { scene.board.send(GraphChange.HideLines(spec.id, entry.lines, !isHidden)) }
    Row(
        Modifier.clickable(role = Role.Button, onClick = toggle)
            .semantics { contentDescription = if (isHidden) "Show ${entry.name}" else "Hide ${entry.name}" },
        horizontalArrangement = Arrangement.spacedBy(5.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        LineColor(entry.color, isHidden)
        LineName(listOfNotNull(entry.name, entry.log?.let { shortLabel(it, LABEL_LETTERS) }).joinToString(" · "), isHidden)
        XyValue(scene, entry)
    }
}

/** The place of [entry] at the cursor. It is drawn without layout, because the cursor moves as fast as the mouse. */
@Composable
private fun XyValue(scene: GraphScene, entry: XyEntry) {
    val palette = LocalPalette.current
    val letters = rememberTextMeasurer()
    val style = remember(palette) { TextStyle(color = palette.text, fontSize = 12.sp, fontWeight = FontWeight.Medium) }
    Spacer(
        Modifier.width(VALUE_WIDTH).height(17.dp).drawBehind {
            val text = entry.textAt(Cursors(pinned = scene.view.cursor))
            val room = Constraints(maxWidth = size.width.toInt())
            drawText(letters.measure(text, style, TextOverflow.Ellipsis, softWrap = false, maxLines = 1, constraints = room))
        },
    )
}

private val VALUE_WIDTH = 130.dp
private const val MAX_ENTRIES = 8
private const val LABEL_LETTERS = 20
