package badlog.viewer.draw.plot

import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.Points

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
