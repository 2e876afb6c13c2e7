package badlog.viewer.draw.plot

import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.pen.Pen

/** Draws [marks] over a whole log as a strip in [frame]. Modes with their names are first, then the [lines], events, findings and notes. */
fun Pen.drawOverview(frame: PlotFrame, marks: PlotMarks, colors: PenColors, lines: () -> Unit = {}) {
    drawModes(frame, marks.modes, colors, hasNames = true)
    lines()
    drawEventMarks(frame, marks.events, colors, hasLines = false)
    marks.findings?.let { drawFindingMarks(frame, it, colors) }
    drawNoteMarks(frame, marks.notes, colors)
}
