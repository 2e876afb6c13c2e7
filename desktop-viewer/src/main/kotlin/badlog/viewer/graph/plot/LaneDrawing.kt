package badlog.viewer.graph.plot

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.compositeOver
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.sp
import badlog.analysis.Span
import badlog.viewer.theme.Palette

/** Draws the lanes of [picture] where [visible] is seen now, each block with its state's name where that fits. */
internal fun DrawScope.drawLanes(picture: PlotPicture, visible: Span, palette: Palette, letters: TextMeasurer) {
    if (picture.lanes.isEmpty()) return
    val made = picture.request
    val stretch = made.visible.width / visible.width * size.width / made.width
    val shift = (made.visible.from - visible.from) / visible.width * size.width
    clipRect {
        picture.lanes.forEachIndexed { index, lane ->
            val top = picture.laneTop(index)
            val height = picture.laneHeight - GAP * made.density
            for (block in lane.blocks) {
                val left = (block.left * stretch + shift).toFloat().coerceAtLeast(0f)
                val right = (block.right * stretch + shift).toFloat().coerceAtMost(size.width)
                if (right <= left) continue
                val narrow = right - left < NARROW * made.density
                drawRect(laneColour(lane.states, block.state, palette, narrow), Offset(left, top), Size(right - left, height))
                drawName(lane.states.getOrElse(block.state) { "?" }, left, right, top, height, palette, letters)
            }
        }
    }
}

/** How high a lane is, in pixels, with the room to the next. */
internal val PlotPicture.laneHeight: Float get() = (request.height - plotHeight) / maxOf(lanes.size, 1)

/** Where lane [index] begins, in pixels from the graph's top. */
internal fun PlotPicture.laneTop(index: Int): Float = plotHeight + index * laneHeight

/**
 * The colour of [state], one of [states]: quiet enough for a name upon it, unless its block is too [narrow] for one and would not be
 * seen. Of a switch, off is the quiet one: where it is pressed has to be seen at a glance.
 */
internal fun laneColour(states: List<String>, state: Int, palette: Palette, narrow: Boolean): Color {
    val isOff = state == 0 && states.size == 2 && states[0] == "false"
    return when {
        isOff -> palette.stateOff
        narrow -> palette.line(state)
        else -> palette.line(state).copy(alpha = if (palette.isDark) 0.5f else 0.35f).compositeOver(palette.surface)
    }
}

private fun DrawScope.drawName(
    name: String,
    left: Float,
    right: Float,
    top: Float,
    height: Float,
    palette: Palette,
    letters: TextMeasurer,
) {
    val margin = MARGIN * density
    val room = (right - left - 2 * margin).toInt()
    if (room < LEAST_ROOM * density || height < LETTERS * density) return
    val style = TextStyle(color = palette.text, fontSize = LETTERS.sp)
    val text = letters.measure(
        name.take(MOST_LETTERS),
        style,
        TextOverflow.Ellipsis,
        softWrap = false,
        maxLines = 1,
        Constraints(maxWidth = room),
    )
    // A few letters of a name say nothing, or what another state is called.
    if (text.hasVisualOverflow && room < LEAST_ROOM_OF_A_PART * density) return
    drawText(text, topLeft = Offset(left + margin, top + (height - text.size.height) / 2))
}

private const val GAP = 2f
private const val NARROW = 4f
private const val MARGIN = 5f
private const val LETTERS = 11
private const val LEAST_ROOM = 12
private const val LEAST_ROOM_OF_A_PART = 44
private const val MOST_LETTERS = 80
