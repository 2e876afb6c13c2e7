package badlog.window.graph

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
import androidx.compose.material3.Icon
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Offset
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
import badlog.viewer.shown.comparison.shortLabel
import badlog.viewer.shown.cursor.comparisonText
import badlog.viewer.shown.statistics.StateTime
import badlog.viewer.shown.statistics.timesOf
import badlog.viewer.state.GraphChange
import badlog.viewer.text.exactText
import badlog.viewer.text.numberText
import badlog.viewer.text.unitText
import badlog.window.graph.plot.DrawnLine
import badlog.window.graph.plot.PlotPicture
import badlog.window.graph.scene.GraphScene
import badlog.window.log.valueText
import badlog.window.theme.Icons
import badlog.window.theme.LineColor
import badlog.window.theme.LineName
import badlog.window.theme.LocalPalette
import badlog.window.theme.Tip

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
    return scene.plots.curves.runs(line.recording, line.signal)
        .timesOf(line.signal.states.orEmpty(), span.from - line.offset, span.to - line.offset)
        .take(StateTime.MOST)
        .joinToString("\n") { it.text(line.recording.view.xAxis) }
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
