package badlog.viewer.draw.plot

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.draw.pen.Pen
import kotlin.math.round

/**
 * The content of one frame, ready for drawing: lines, lanes, or lines with lanes below.
 *
 * @property axes the y axes of [lines], the left one first.
 * @property laneShare the fraction of the height that [lanes] take, from 0 to 1.
 * @property isFilled whether the areas between the lines and 0 are filled.
 */
class Plot(
    val axes: List<PlotAxis>,
    val lines: List<PlotLine>,
    val lanes: List<PlotLane>,
    val laneShare: Double,
    val isFilled: Boolean = false,
)

/** The marks that all frames of a log show besides their lines; [notes] are places on x. */
class PlotMarks(val modes: ModeTimeline, val events: EventTimeline, val findings: FindingTimeline<*>?, val notes: List<Double>)

/**
 * Draws [plot] with its axes and all [marks] in and around [frame].
 *
 * @param xHeight the room for the numbers of x below it; 0 if they are not drawn.
 * @param hasRoom whether there is room for a y axis to the right of it.
 * @param made the frame for which [plot] was made, if it is not [frame].
 * @param lines draws the lines in their part of the frame.
 */
fun Pen.drawPlot(
    frame: PlotFrame,
    plot: Plot,
    marks: PlotMarks,
    colors: PenColors,
    xHeight: Double,
    hasRoom: Boolean = false,
    made: PlotFrame = frame,
    lines: (PlotFrame) -> Unit = { drawLines(it, plot.lines, plot.axes, plot.isFilled, colors) },
) {
    val lineFrame = frame.part(0.0, 1 - plot.laneShare)
    val laneFrame = frame.part(1 - plot.laneShare, 1.0)
    if (plot.laneShare < 1) drawModes(lineFrame, marks.modes, colors)
    drawGrid(frame, lineFrame, plot.axes, colors)
    if (xHeight > 0) drawXNumbers(frame, frame.right + frame.left, xHeight, colors)
    lines(lineFrame)
    drawYNumbers(lineFrame, plot.axes, colors, hasRoom)
    drawLanes(laneFrame, plot.lanes, colors, haveNames = plot.lanes.size > 1 || plot.lines.isNotEmpty(), made)
    // They are on top of the lanes, which would hide them.
    if (plot.laneShare > 0) drawModes(laneFrame, marks.modes, colors)
    marks.findings?.let { drawFindingMarks(frame, it, colors) }
    drawEventMarks(frame, marks.events, colors)
    drawNoteMarks(frame, marks.notes, colors)
}

/**
 * The frame of a plot, in physical pixels, and the part of x that it shows.
 *
 * @property shown the part of x.
 */
class PlotFrame(val left: Double, val top: Double, val width: Double, val height: Double, val shown: Span) {
    /** The scale of x over the frame's width. */
    val x: Scale = Scale.ofX(shown, width, left)
    val right: Double get() = left + width
    val bottom: Double get() = top + height

    /** Returns the same frame with another part of x. */
    fun showing(x: Span): PlotFrame = PlotFrame(left, top, width, height, x)

    /** Returns the part of the frame from [from] to [to], fractions of its height. */
    fun part(from: Double, to: Double): PlotFrame = PlotFrame(left, top + from * height, width, (to - from) * height, shown)

    /** Returns the scale on which [shown] fills the frame's height. */
    fun scaleOf(shown: Span): Scale = Scale.ofY(shown, height, top)

    /** Returns the height of 0 on [y], or of the nearest edge: filled areas end there. */
    fun baselineOf(y: Scale): Double = y.placeOf(0.0).coerceIn(top, bottom)
}

/** The margins of all plots, in CSS pixels: the same x is at the same place in all of them. The page's style sheet also has them. */
object PlotMargins {
    /** The left margin, for the numbers of y and the names of lanes. */
    const val LEFT: Int = 62

    /** The right margin. */
    const val RIGHT: Int = 14

    /** The margin above the plot, in CSS pixels. */
    const val TOP: Int = 6

    /** The margin below, for the numbers of x. */
    const val BOTTOM: Int = 26

    /** The margins above and below together. */
    const val HEIGHT: Int = TOP + BOTTOM

    /** Returns the frame of a plot of [width] by [height] CSS pixels that shows [x]. A CSS pixel is [density] physical pixels. */
    fun frameOf(width: Int, height: Int, x: Span, density: Double): PlotFrame {
        val left = round(LEFT * density)
        val top = round(TOP * density)
        val right = round((width - RIGHT) * density)
        val bottom = round((height - BOTTOM) * density)
        return PlotFrame(left, top, maxOf(1.0, right - left), bottom - top, x)
    }

    /**
     * Returns the height of a plot with all of [plane] in its frame. The scale is the same for x and y. The plot is [width] CSS pixels
     * wide.
     */
    fun heightOf(plane: Plane, width: Int): Int = ((width - LEFT - RIGHT) * plane.y.width / plane.x.width).toInt() + HEIGHT
}
