package badlog.viewer.draw.plot

import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.color.modeOpacity
import badlog.viewer.draw.color.modeShade
import badlog.viewer.draw.mark.EventMarks
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.draw.mark.ModeBands
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.Points

/**
 * Shades the parts of [frame] in which the robot was enabled, by its mode. If [hasNames] is true, each mode's name is written where there
 * is room.
 */
fun Pen.drawModes(frame: PlotFrame, modes: ModeTimeline, colors: PenColors, hasNames: Boolean = false) {
    if (modes.spans.isEmpty()) return
    val bands = ModeBands().apply { place(modes, frame.shown, frame.width) }
    for (i in 0 until bands.size) {
        val left = frame.left + bands.leftOf(i)
        val width = bands.rightOf(i) - bands.leftOf(i)
        val mode = bands.modeOf(i)
        rectangle(left, frame.top, width, frame.height, faded(colors[modeShade(mode)], modeOpacity(colors.isDark)))
        if (!hasNames || widthOf(mode.title, AXIS_LETTERS * density) > width - 2 * MARGIN * density) continue
        text(mode.title, left + MARGIN * density, frame.top + frame.height / 2, AXIS_LETTERS * density, colors[Shade.MUTED])
    }
}

/**
 * Draws the marks of [events] along the top of [frame]: heads and, in crowds, ticks. If [hasLines] is true, heads have lines down to the
 * bottom.
 */
fun Pen.drawEventMarks(frame: PlotFrame, events: EventTimeline, colors: PenColors, hasLines: Boolean = true) {
    if (events.placedCount == 0) return
    val marks = EventMarks().apply { place(events, frame.shown, frame.width, density) }
    val color = colors[Shade.EVENT]
    val head = HEAD * density
    val lines = Points()
    for (isSerious in listOf(false, true)) {
        lines.clear()
        for (i in 0 until marks.size) {
            val x = frame.left + marks.pixelOf(i) + 0.5
            if (hasLines && marks.hasLine(i) && marks.isSerious(i) == isSerious) lines.line(x, frame.top, x, frame.bottom)
        }
        segments(lines, faded(color, if (isSerious) SERIOUS_OPACITY else LINE_OPACITY), 0.0)
    }
    val ticks = Points()
    val heads = Points()
    for (i in 0 until marks.size) {
        val x = frame.left + marks.pixelOf(i) + 0.5
        if (marks.hasHead(i)) {
            heads.add(x - head, frame.top).add(x + head, frame.top).add(x, frame.top + head * 1.5)
        } else {
            ticks.line(x, frame.top, x, frame.top + head)
        }
    }
    segments(ticks, faded(color, SERIOUS_OPACITY), density)
    shapes(heads, TRIANGLE, color)
}

/** Draws a line and a flag at each of [places], the places of notes. */
fun Pen.drawNoteMarks(frame: PlotFrame, places: List<Double>, colors: PenColors) {
    for (x in places) {
        if (x !in frame.shown) continue
        val left = frame.x.placeOf(x)
        rectangle(left, frame.top, density, frame.height, colors[Shade.ACCENT])
        rectangle(left, frame.top, FLAG_WIDTH * density, FLAG_HEIGHT * density, colors[Shade.ACCENT])
    }
}

private const val MARGIN = 5.0
private const val HEAD = 3.5
private const val TRIANGLE = 3
private const val LINE_OPACITY = 0.2
private const val SERIOUS_OPACITY = 0.5
private const val FLAG_WIDTH = 9
private const val FLAG_HEIGHT = 6
