package badlog.viewer.draw.swerve

import badlog.core.analysis.PixelColumns
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.axis.limitsFor
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.plot.AXIS_LETTERS
import badlog.viewer.draw.plot.PlotAxis
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotLine
import badlog.viewer.draw.plot.drawCursors
import badlog.viewer.draw.plot.drawGrid
import badlog.viewer.draw.plot.drawLines
import badlog.viewer.draw.plot.drawYNumbers
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.swerve.DriveErrors

/** The angle errors of all modules over x, each in the module's color. */
internal class ErrorGraph(errors: DriveErrors) {
    private val curves = errors.modules.map { Curve(it.angle, it.angle.range?.endInclusive) }
    private val strokes = curves.map { Strokes() }

    fun draw(pen: Pen, frame: PlotFrame, cursors: Cursors, colors: PenColors) {
        val columns = PixelColumns(frame.width.toInt())
        for (curve in curves) curve.draw(frame.shown.from, frame.shown.to, columns)
        val seen = curves.filter { !it.min.isNaN() }
        val limits = limitsFor(seen.minOfOrNull { it.min } ?: Double.NaN, seen.maxOfOrNull { it.max } ?: Double.NaN, includesZero = true)
        val axes = listOf(PlotAxis(AxisSide.LEFT, "°", limits, color = null))
        val lines = curves.mapIndexed { i, curve ->
            PlotLine(i, strokes[i].apply { trace(curve, frame.x, frame.scaleOf(limits)) }, axis = 0)
        }
        pen.text(TITLE, frame.left, frame.top - ABOVE * pen.density, AXIS_LETTERS * pen.density, colors[Shade.MUTED])
        pen.drawGrid(frame, frame, axes, colors)
        pen.drawLines(frame, lines, axes, isFilled = false, colors)
        pen.drawYNumbers(frame, axes, colors)
        pen.drawCursors(frame, cursors, colors)
    }

    private companion object {
        const val TITLE = "Angle minus its target"
        const val ABOVE = 11.0
    }
}
