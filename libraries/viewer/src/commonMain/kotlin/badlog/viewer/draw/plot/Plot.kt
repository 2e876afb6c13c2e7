package badlog.viewer.draw.plot

import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.draw.pen.Pen

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
