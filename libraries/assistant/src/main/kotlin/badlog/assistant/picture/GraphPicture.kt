package badlog.assistant.picture

import badlog.charts.look.SvgRaster
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.viewer.choices.range.holdsUntil
import badlog.viewer.choices.range.stateRuns
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.axis.graphAxes
import badlog.viewer.draw.axis.limitsFor
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.figure.LegendEntry
import badlog.viewer.draw.figure.Sheet
import badlog.viewer.draw.figure.graphHead
import badlog.viewer.draw.figure.xTitle
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.lane.LaneLook
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.draw.pen.SvgPen
import badlog.viewer.draw.plot.Plot
import badlog.viewer.draw.plot.PlotAxis
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotLane
import badlog.viewer.draw.plot.PlotLine
import badlog.viewer.draw.plot.PlotMargins
import badlog.viewer.draw.plot.PlotMarks
import badlog.viewer.draw.plot.drawPlot
import badlog.viewer.text.shortNames
import kotlin.math.ceil

/**
 * A picture of graphs for an assistant. It has a plot for each unit and one for all states, over the same x, shaded where the robot was
 * enabled.
 *
 * @param title the heading.
 * @param lines the lines to draw, each in its own color.
 * @param range the range of x to draw, not empty.
 * @param width the width of the picture, in pixels.
 */
internal class GraphPicture(
    private val view: LogView,
    private val title: String,
    lines: List<GraphSeries>,
    private val range: Span,
    private val width: Int,
) {
    private class NamedLine(val line: GraphSeries, val name: String, val color: Int)

    private val marks = PlotMarks(ModeTimeline.of(view), EventTimeline.NONE, findings = null, notes = emptyList())
    private val numbers: List<NamedLine>
    private val states: List<NamedLine>

    init {
        val names = shortNames(lines.map { it.topic.name })
        val named = lines.mapIndexed { i, line -> NamedLine(line, names[i].take(MAX_LABEL_LENGTH), i) }
        val (ofStates, ofNumbers) = named.partition { it.line.states != null }
        states = ofStates
        numbers = ofNumbers
    }

    /** The height of the picture in pixels; 0 until it is drawn. */
    var height: Int = 0
        private set

    /** Returns the picture as the bytes of a PNG, because assistants do not accept SVG. */
    fun png(): ByteArray {
        val pen = SvgPen(SvgRaster::widthOf)
        val sheet = Sheet(width, pen)
        sheet.line(TITLE_LINE)
        sheet.text(title, TITLE, PenColors.LIGHT[Shade.TEXT], isBold = true)
        for (axis in graphAxes(numbers.map { it.line.unit })) sheet.lines(axis)
        if (states.isNotEmpty()) sheet.lanes()
        sheet.xTitle(view.xAxis.title.take(MAX_LABEL_LENGTH))
        height = ceil(sheet.height).toInt()
        val svg = pen.document(width.toDouble(), height.toDouble(), PenColors.LIGHT[Shade.SURFACE])
        return SvgRaster.png(svg, width, height)
    }

    private fun Sheet.lines(axis: GraphAxis) {
        val shown = axis.lines.map(numbers::get)
        graphHead(
            shown.joinToString { it.name },
            axis.unit,
            if (shown.size < 2) {
                emptyList()
            } else {
                shown.map { LegendEntry(it.name, it.color) }
            },
        )
        plot(PANEL) { frame ->
            val strokes = shown.map { strokesOf(it.line, frame) }
            val seen = strokes.filter { !it.min.isNaN() }
            val limits =
                limitsFor(seen.minOfOrNull { it.min } ?: Double.NaN, seen.maxOfOrNull { it.max } ?: Double.NaN, includesZero = false)
            for (one in strokes) one.place(frame.scaleOf(limits))
            val lines = shown.zip(strokes) { line, drawn -> PlotLine(line.color, drawn, axis = 0) }
            Plot(listOf(PlotAxis(AxisSide.LEFT, axis.unit, limits, color = null)), lines, emptyList(), laneShare = 0.0)
        }
    }

    private fun strokesOf(line: GraphSeries, frame: PlotFrame): Strokes {
        val curve = Curve(line.data, line.holdsUntil)
        curve.draw(range.from, range.to, PixelColumns(frame.width.toInt()))
        return Strokes().apply { trace(curve, frame.x, Scale.NONE) }
    }

    private fun Sheet.lanes() {
        graphHead("States", unit = "", emptyList())
        plot(states.size * LaneLook.HEIGHT) { frame ->
            val lanes = states.map { state ->
                val blocks = LaneBlocks().apply { place(state.line.stateRuns(), range, frame.width, density = 1.0) }
                PlotLane(state.name, state.line.states.orEmpty(), blocks)
            }
            Plot(emptyList(), emptyList(), lanes, laneShare = 1.0)
        }
    }

    private fun Sheet.plot(high: Int, made: (PlotFrame) -> Plot) {
        val frame = PlotMargins.frameOf(width, high + PlotMargins.HEIGHT, range, density = 1.0)
        part(high + PlotMargins.HEIGHT.toDouble()) {
            it.drawPlot(frame, made(frame), marks, PenColors.LIGHT, PlotMargins.BOTTOM.toDouble())
        }
    }
}

private const val MAX_LABEL_LENGTH = 60
private const val TITLE_LINE = 26.0
private const val TITLE = 15.0
private const val PANEL = 180
