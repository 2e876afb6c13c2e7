package badlog.viewer.draw.plot

import badlog.core.analysis.Span
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.lane.LaneLook
import badlog.viewer.draw.lane.LaneTone
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.Points
import badlog.viewer.draw.pen.TextSide
import badlog.viewer.draw.pen.fittedEnds
import kotlin.math.round

/**
 * A line of numbers, ready for drawing.
 *
 * @property color the index of the line's color, from 0.
 * @property strokes the strokes and dots, in physical pixels.
 * @property axis the index of the line's y axis.
 */
class PlotLine(val color: Int, val strokes: Strokes, val axis: Int)

/**
 * A y axis, ready for drawing.
 *
 * @property shown the visible part of y.
 * @property color the index of the color of its numbers, if there are other axes and it has a single line; null for the color of other
 *   texts.
 */
class PlotAxis(val side: AxisSide, val unit: String, val shown: Span, val color: Int?) {
    companion object {
        /** Returns [axes] with their [limits], for lines with these [colors]. */
        fun of(axes: List<GraphAxis>, limits: List<Span>, colors: (Int) -> Int): List<PlotAxis> = axes.mapIndexed { i, axis ->
            PlotAxis(axis.side, axis.unit, limits[i], if (axes.size > 1) axis.lines.singleOrNull()?.let(colors) else null)
        }
    }
}

/**
 * A lane of states, ready for drawing.
 *
 * @property states the name of each state.
 * @property blocks the blocks, in physical pixels from the left of the frame; null if the lane is hidden, but keeps its place.
 */
class PlotLane(val name: String, val states: List<String>, val blocks: LaneBlocks?)

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
                    drawBlock(left, right - left, top + height * i, height - LANE_GAP * density, lane.states, blocks.states[block], colors)
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

private const val LANE_GAP = 2
private const val LETTER_SHARE = 0.58

/** Draws [lines], each on one of [axes], within [frame]; with the areas down to 0 if they are [isFilled]. */
fun Pen.drawLines(frame: PlotFrame, lines: List<PlotLine>, axes: List<PlotAxis>, isFilled: Boolean, colors: PenColors) {
    if (lines.isEmpty()) return
    // A line along an edge is visible in its whole width.
    val margin = LINE_WIDTH * density
    clip(frame.left, frame.top - margin, frame.width, frame.height + 2 * margin) {
        for (line in lines) {
            val color = colors.line(line.color)
            if (isFilled) areas(line.strokes, frame.baselineOf(frame.scaleOf(axes[line.axis].shown)), faded(color, AREA_OPACITY))
            lines(line.strokes, color, if (line.strokes.isDense) 0.0 else LINE_WIDTH * density)
        }
    }
    val dots = Points()
    for (line in lines) {
        val radius = density * if (line.strokes.isSparse) DOT_RADIUS else LONE_RADIUS
        dots.clear()
        for (at in 0 until line.strokes.dotsSize step 2) {
            val x = line.strokes.dots[at]
            val y = line.strokes.dots[at + 1]
            if (x in frame.left - radius..frame.right + radius && y in frame.top - radius..frame.bottom + radius) dots.add(x, y)
        }
        dots(dots, radius, colors.line(line.color))
    }
}

private const val LINE_WIDTH = 1.5
private const val DOT_RADIUS = 2.5
private const val LONE_RADIUS = 1.0
private const val AREA_OPACITY = 0.19

/** The font size of the numbers of axes, in CSS pixels or dp. */
const val AXIS_LETTERS: Double = 11.0

/**
 * Draws the grid. Lines go across [frame] at the ticks of x, and across [lineFrame], its part with lines, at the ticks of the first of
 * [axes].
 */
fun Pen.drawGrid(frame: PlotFrame, lineFrame: PlotFrame, axes: List<PlotAxis>, colors: PenColors) {
    // A line of one pixel is sharp at the middle of a pixel.
    val middle = density % 2 / 2
    val lines = Points()
    for (place in placesOf(xTicks(frame), frame.x)) lines.line(place + middle, frame.top, place + middle, frame.bottom)
    axes.firstOrNull()?.let { axis ->
        val rows = placesOf(Ticks.ofY(axis.shown, lineFrame.height / density), lineFrame.scaleOf(axis.shown))
        for (place in rows) lines.line(frame.left, place + middle, frame.right, place + middle)
    }
    segments(lines, colors[Shade.GRID], density)
}

/** Draws the numbers of x below [frame], over [width] pixels from the left edge of the drawing. Graphs of the same width share them. */
fun Pen.drawXNumbers(frame: PlotFrame, width: Double, height: Double, colors: PenColors) {
    layer("x numbers", 0.0, frame.bottom, width, height, listOf(frame.shown, frame.left, colors)) { pen, _ ->
        val ticks = xTicks(frame)
        pen.writeNumbers(ticks, placesOf(ticks, frame.x), top = 0.0, colors)
    }
}

/**
 * Draws the x axis as a bar in [frame], below graphs. It has marks at the ticks, their numbers, and [title] at the right end. Numbers leave
 * room for the title.
 */
fun Pen.drawXBar(frame: PlotFrame, title: String, colors: PenColors) {
    val ticks = xTicks(frame)
    val places = placesOf(ticks, frame.x)
    val middle = density % 2 / 2
    val edge = Points().line(frame.left, frame.top + middle, frame.right, frame.top + middle)
    segments(edge, colors[Shade.BORDER], density)
    val marks = Points()
    for (place in places) marks.line(place + middle, frame.top, place + middle, frame.top + TICK * density)
    segments(marks, colors[Shade.MUTED], density)
    val name = fittedEnds(title, frame.width * TITLE_SHARE, AXIS_LETTERS * density)
    val room = frame.right - widthOf(name, AXIS_LETTERS * density) - TITLE_GAP * density
    text(name, frame.right, frame.top + NUMBER_MIDDLE * density, AXIS_LETTERS * density, colors[Shade.MUTED], TextSide.LEFT)
    writeNumbers(ticks, places, frame.top, colors, room)
}

/** Draws a flag in [shade] at the place [x] on the bar of the x axis in [frame], with [text] about it. */
fun Pen.drawFlag(frame: PlotFrame, x: Double, text: String, shade: Shade, colors: PenColors) {
    val margin = FLAG_MARGIN * density
    val width = widthOf(text, AXIS_LETTERS * density) + 2 * margin
    val left = (frame.x.placeOf(x) - width / 2).coerceIn(frame.left, maxOf(frame.left, frame.right - width))
    val box = roundedBox(left, frame.top + 1, width, frame.height - 3 * density, FLAG_RADIUS * density)
    shapes(box, ROUNDED_CORNERS, colors[shade])
    text(text, left + margin, frame.top + frame.height / 2 - density, AXIS_LETTERS * density, colors[Shade.SURFACE])
}

/**
 * Draws the numbers of [axes] at the sides of [frame].
 *
 * @param hasRoom whether there is room to the right of the frame. Otherwise the right axis is inside, with an outline: beside the frame it
 *   would take width from all graphs, because their x axes must be aligned, although only a few graphs need it.
 */
fun Pen.drawYNumbers(frame: PlotFrame, axes: List<PlotAxis>, colors: PenColors, hasRoom: Boolean = false) {
    for (axis in axes) {
        if (axis.side == AxisSide.NONE) continue
        val ticks = Ticks.ofY(axis.shown, frame.height / density)
        val texts = ticks.texts
        val y = frame.scaleOf(axis.shown)
        val color = if (axis.color == null) colors[Shade.MUTED] else colors.line(axis.color)
        val half = AXIS_LETTERS / 2 * density
        texts.forEachIndexed { i, number ->
            val middle = y.placeOf(ticks.values[i]).coerceIn(frame.top + half, maxOf(frame.top + half, frame.bottom - half))
            val isOutside = axis.side == AxisSide.LEFT || hasRoom
            // The unit is shown once, at the top, if it is short enough.
            val isTop = i == texts.lastIndex && axis.unit.isNotEmpty()
            val text = if (isTop && (!isOutside || number.length + axis.unit.length < MAX_WITH_UNIT)) "$number ${axis.unit}" else number
            when {
                axis.side == AxisSide.LEFT -> text(text, frame.left - GAP * density, middle, 2 * half, color, TextSide.LEFT)

                hasRoom -> text(text, frame.right + GAP * density, middle, 2 * half, color)

                else -> {
                    val place = frame.right - INNER_GAP * density
                    text(text, place, middle, 2 * half, color, TextSide.LEFT, halo = colors[Shade.SURFACE])
                }
            }
        }
    }
}

/** Writes the numbers of [ticks], which are at [places], below the height [top]. The last ones are omitted if they would reach [room]. */
private fun Pen.writeNumbers(ticks: Ticks, places: DoubleArray, top: Double, colors: PenColors, room: Double = Double.POSITIVE_INFINITY) {
    val letters = AXIS_LETTERS * density
    ticks.texts.forEachIndexed { i, number ->
        if (room < Double.POSITIVE_INFINITY && places[i] + widthOf(number, letters) / 2 >= room) return
        text(number, places[i], top + NUMBER_MIDDLE * density, letters, colors[Shade.MUTED], TextSide.CENTER)
    }
}

private fun Pen.xTicks(frame: PlotFrame) = Ticks.ofX(frame.shown, frame.width / density)

private fun placesOf(ticks: Ticks, scale: Scale) = DoubleArray(ticks.values.size) { round(scale.placeOf(ticks.values[it])) }

private const val GAP = 6.0
private const val NUMBER_MIDDLE = GAP + AXIS_LETTERS / 2
private const val TICK = 4.0
private const val TITLE_SHARE = 0.25
private const val TITLE_GAP = 12.0
private const val FLAG_MARGIN = 6.0
private const val FLAG_RADIUS = 3.0
private const val INNER_GAP = 3.0
private const val MAX_WITH_UNIT = 9
