package badlog.viewer.graph

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.plot.board.BoardGraph
import badlog.plot.text.unitText
import badlog.viewer.compare.shortLabel
import badlog.viewer.graph.plot.DrawnLine
import badlog.viewer.graph.plot.PlotPicture
import badlog.viewer.graph.scene.GraphScene
import badlog.viewer.recording.valueText
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette

/** A line's color, name where it [hasName], and its value under the cursor. */
@Composable
internal fun LegendEntry(scene: GraphScene, spec: BoardGraph, line: DrawnLine, hasName: Boolean) {
    val palette = LocalPalette.current
    val interactions = remember { MutableInteractionSource() }
    val isHovered by interactions.collectIsHoveredAsState()
    Row(
        Modifier.hoverable(interactions),
        horizontalArrangement = Arrangement.spacedBy(5.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        if (line.signal.states == null) {
            Spacer(Modifier.size(10.dp, 3.dp).background(palette.line(line.color), RoundedCornerShape(2.dp)))
        }
        val name = listOfNotNull(
            line.signal.title.takeIf {
                hasName
            },
            line.label?.let { shortLabel(it, LABEL_LETTERS) },
        ).joinToString(" · ")
        if (name.isNotEmpty()) {
            Text(name, Modifier.widthIn(max = 260.dp), fontSize = 12.sp, maxLines = 1, overflow = TextOverflow.Ellipsis)
        }
        LegendValue(scene, spec.id, line)
        if (isHovered && hasName && spec.lines.size > 1) {
            Icon(
                Icons.Close,
                "Remove ${line.signal.title}",
                Modifier.size(12.dp).clickable {
                    scene.board.change { withoutLine(spec.id, line.signal.name) }
                },
                palette.muted,
            )
        }
    }
}

/** The value of [line] under the cursor. It is drawn, not laid out: the cursor moves at the speed of the mouse. */
@Composable
private fun LegendValue(scene: GraphScene, id: Int, line: DrawnLine) {
    val palette = LocalPalette.current
    val letters = rememberTextMeasurer()
    val style = remember(palette) { TextStyle(color = palette.text, fontSize = 12.sp, fontWeight = FontWeight.Medium) }
    val unit = remember(palette) { TextStyle(color = palette.muted, fontSize = 12.sp) }
    Spacer(
        Modifier.width(if (line.signal.states == null) 104.dp else 84.dp).height(17.dp).drawBehind {
            val text = readingOf(scene.pictureOf(scene.plots.state(id)), line, scene.view.cursor)
            val layout = letters.measure(
                text.ifEmpty { unitText(line.signal.unit) },
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

/** What [line] says at the [cursor]; empty without a cursor, and while [picture] does not have the line yet. */
internal fun readingOf(picture: PlotPicture?, line: DrawnLine, cursor: Double?): String {
    if (picture == null || cursor == null) return ""
    val isThere = picture.lines.any { it.line == line } || picture.lanes.any { it.line == line }
    return if (isThere) valueText(line.signal, cursor - line.offset) else ""
}

/** More letters of a recording's name leave no room for others. */
private const val LABEL_LETTERS = 28
