package badlog.window.graph

import androidx.compose.foundation.layout.Spacer
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.sp
import badlog.core.analysis.Span
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.axis.Ticks
import badlog.window.graph.plot.DrawnLine
import badlog.window.graph.plot.PlotPicture
import badlog.window.graph.plot.PlotState
import badlog.window.graph.plot.YAxis
import badlog.window.graph.plot.laneHeight
import badlog.window.graph.plot.laneTop
import badlog.window.graph.plot.pixelOf
import badlog.window.graph.scene.GraphScene
import badlog.window.theme.LocalPalette
import badlog.window.theme.Palette

/** The texts beside a plot: the numbers of its axes, in color if an axis has only one line, and its lanes' names. */
@Composable
internal fun YAxes(scene: GraphScene, state: PlotState, modifier: Modifier) {
    val palette = LocalPalette.current
    val letters = rememberTextMeasurer(cacheSize = TEXTS)
    val style = remember(palette) { TextStyle(color = palette.muted, fontSize = 11.sp) }
    Spacer(
        modifier.drawBehind {
            val picture = scene.pictureOf(state) ?: return@drawBehind
            val left = GraphScene.LEFT_GUTTER.toPx()
            val right = size.width - scene.rightGutter.toPx()
            val margin = MARGIN * density
            picture.axes.forEachIndexed { index, axis ->
                val numbers = styleOf(picture, index, style, palette)
                when (axis.axis.side) {
                    AxisSide.LEFT -> drawNumbers(axis, picture, letters, numbers) { width -> left - margin - width }
                    AxisSide.RIGHT -> drawNumbers(axis, picture, letters, numbers) { right + margin }
                    AxisSide.NONE -> Unit
                }
            }
            picture.lanes.forEachIndexed { index, lane ->
                val text = letters.measure(
                    laneName(lane.line, picture.lanes.map { it.line }),
                    style,
                    if (lane.line.label == null) TextOverflow.Ellipsis else TextOverflow.MiddleEllipsis,
                    softWrap = false,
                    maxLines = 1,
                    constraints = Constraints(maxWidth = (left - 2 * margin).toInt().coerceAtLeast(1)),
                )
                val top = picture.laneTop(index) + (picture.laneHeight - text.size.height) / 2
                drawText(text, topLeft = Offset(left - margin - text.size.width, top))
            }
        },
    )
}

/** Returns the text beside the lane of [line], one of [all]: with several recordings, each has a lane with the same name. */
internal fun laneName(line: DrawnLine, all: List<DrawnLine>): String {
    val label = line.label?.take(MAX_LETTERS) ?: return line.title.take(MAX_LETTERS)
    return if (all.all { it.signal.name == line.signal.name }) label else "${line.title.take(MAX_LETTERS)} · $label"
}

/** Two axes are distinguished by the colors of their lines. */
private fun styleOf(picture: PlotPicture, axis: Int, style: TextStyle, palette: Palette): TextStyle {
    val lines = picture.lines.filter { it.axis == axis }
    return if (picture.axes.size > 1 && lines.size == 1) style.copy(color = palette.line(lines.single().line.color)) else style
}

private fun DrawScope.drawNumbers(
    axis: YAxis,
    picture: PlotPicture,
    letters: TextMeasurer,
    style: TextStyle,
    left: (width: Int) -> Float,
) {
    val last = axis.ticks.texts.lastIndex
    axis.ticks.texts.forEachIndexed { index, number ->
        // The unit is shown once, at the top, if it is short enough.
        val unit = axis.axis.unit
        val hasUnit = index == last && unit.isNotEmpty() && number.length + unit.length < MAX_WITH_UNIT
        val text = letters.measure(if (hasUnit) "$number $unit" else number, style)
        val y = axis.pixelOf(axis.ticks.values[index], picture.plotHeight) - text.size.height / 2
        // A text that would be partly outside is moved inside.
        drawText(text, topLeft = Offset(left(text.size.width), y.coerceIn(0f, maxOf(0f, picture.plotHeight - text.size.height))))
    }
}

/** The lines behind a plot, at the ticks of the left axis and those of x. */
internal fun DrawScope.drawGrid(picture: PlotPicture, visible: Span, palette: Palette) {
    // In the text's color, so that it is also visible on shaded parts.
    val color = palette.text.copy(alpha = GRID_OPACITY)
    picture.axes.firstOrNull()?.let { axis ->
        for (value in axis.ticks.values) {
            val y = axis.pixelOf(value, picture.plotHeight)
            drawLine(color, Offset(0f, y), Offset(size.width, y))
        }
    }
    for (value in Ticks.ofX(visible, size.width.toDp().value.toDouble()).values) {
        val x = pixelOf(value, visible, size.width)
        drawLine(color, Offset(x, 0f), Offset(x, size.height))
    }
}

private const val GRID_OPACITY = 0.08f
private const val TEXTS = 64
private const val MARGIN = 6
private const val MAX_LETTERS = 40
private const val MAX_WITH_UNIT = 9
