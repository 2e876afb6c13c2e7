package badlog.viewer.draw.plot

import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.lane.LaneLook
import badlog.viewer.draw.lane.LaneTone
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.TextSide
import badlog.viewer.draw.pen.fittedEnds

/**
 * Draws [lanes] below one another in [frame], each block with its state's name if that fits. If they [haveNames], each lane's name is to
 * the left.
 *
 * @param made the frame for which the blocks were placed. While a person zooms, they are stretched until new ones are ready.
 */
fun Pen.drawLanes(frame: PlotFrame, lanes: List<PlotLane>, colors: PenColors, haveNames: Boolean, made: PlotFrame = frame) {
    if (lanes.isEmpty()) return
    val height = frame.height / lanes.size
    val letters = LaneLook.LETTERS * density
    val start = frame.x.placeOf(made.shown.from)
    val stretch = (frame.x.placeOf(made.shown.to) - start) / made.width
    val top = frame.top
    clip(frame.left, frame.top, frame.width, frame.height) {
        lanes.forEachIndexed { i, lane ->
            val blocks = lane.blocks ?: return@forEachIndexed
            for (block in 0 until blocks.size) {
                val left = (start + blocks.left[block] * stretch).coerceAtLeast(frame.left)
                val right = (start + blocks.right[block] * stretch).coerceAtMost(frame.right)
                if (right > left) {
                    drawBlock(left, right - left, top + height * i, height - GAP * density, lane.states, blocks.states[block], colors)
                }
            }
        }
    }
    if (!haveNames) return
    val room = frame.left - 2 * LaneLook.MARGIN * density
    lanes.forEachIndexed { i, lane ->
        val middle = frame.top + height * (i + 0.5)
        val place = frame.left - LaneLook.MARGIN * density
        text(fittedEnds(lane.name, room, letters), place, middle, letters, colors[Shade.MUTED], TextSide.LEFT)
    }
}

private fun Pen.drawBlock(left: Double, width: Double, top: Double, height: Double, states: List<String>, state: Int, colors: PenColors) {
    val color = when (LaneTone.of(states, state, width / density)) {
        LaneTone.OFF -> colors[Shade.STATE_OFF]
        LaneTone.QUIET -> colors.state(state)
        LaneTone.STRONG -> colors.line(state)
    }
    rectangle(left, top, width, height, color)
    val room = width - 2 * LaneLook.MARGIN * density
    if (!LaneLook.hasRoom(room / density, isWhole = true) || height < LaneLook.LETTERS * density) return
    val name = stateNameIn(states.getOrElse(state) { "?" }, room) ?: return
    text(name, left + LaneLook.MARGIN * density, top + height / 2, LaneLook.LETTERS * density, colors[Shade.STATE_TEXT])
}

/** Returns [name], or as much of it as fits into [room] and still means something; null if nothing does. */
private fun Pen.stateNameIn(name: String, room: Double): String? {
    val letters = LaneLook.LETTERS * density
    // Estimates first, because measuring a text takes longer than drawing a block.
    val fitting = (room / (letters * LETTER_SHARE)).toInt()
    val fits = name.length < fitting || widthOf(name, letters) <= room
    if (!LaneLook.hasRoom(room / density, isWhole = fits)) return null
    return if (fits) name else name.take(fitting - 1) + "…"
}

private const val GAP = 2
private const val LETTER_SHARE = 0.58
