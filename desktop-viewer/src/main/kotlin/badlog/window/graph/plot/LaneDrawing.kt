package badlog.window.graph.plot

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.sp
import badlog.core.analysis.Span
import badlog.viewer.draw.lane.LaneLook
import badlog.viewer.draw.lane.LaneTone
import badlog.window.theme.Palette

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
            for (block in 0 until lane.blocks.size) {
                val left = (lane.blocks.left[block] * stretch + shift).toFloat().coerceAtLeast(0f)
                val right = (lane.blocks.right[block] * stretch + shift).toFloat().coerceAtMost(size.width)
                if (right <= left) continue
                val state = lane.blocks.states[block]
                val tone = LaneTone.of(lane.states, state, (right - left).toDouble() / made.density)
                drawRect(laneColor(tone, state, palette), Offset(left, top), Size(right - left, height))
                drawName(lane.states.getOrElse(state) { "?" }, left, right, top, height, palette, letters)
            }
        }
    }
}

/** The height of a lane in pixels, with the space to the next. */
internal val PlotPicture.laneHeight: Float get() = (request.height - plotHeight) / maxOf(lanes.size, 1)

/** Returns where lane [index] begins, in pixels from the graph's top. */
internal fun PlotPicture.laneTop(index: Int): Float = plotHeight + index * laneHeight

/** Returns the color of a block in [state] that has [tone]. */
internal fun laneColor(tone: LaneTone, state: Int, palette: Palette): Color = when (tone) {
    LaneTone.OFF -> palette.stateOff
    LaneTone.QUIET -> palette.state(state)
    LaneTone.STRONG -> palette.line(state)
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
    val margin = LaneLook.MARGIN.toFloat() * density
    val room = (right - left - 2 * margin).toInt()
    val visibleRoom = room.toDouble() / density
    if (!LaneLook.hasRoom(visibleRoom, isWhole = true) || height < LaneLook.LETTERS * density) return
    val style = TextStyle(color = palette.stateText, fontSize = LaneLook.LETTERS.sp)
    val text = letters.measure(
        name.take(MAX_LETTERS),
        style,
        TextOverflow.Ellipsis,
        softWrap = false,
        maxLines = 1,
        Constraints(maxWidth = room),
    )
    if (!LaneLook.hasRoom(visibleRoom, isWhole = !text.hasVisualOverflow)) return
    drawText(text, topLeft = Offset(left + margin, top + (height - text.size.height) / 2))
}

private const val GAP = 2f
private const val MAX_LETTERS = 80
