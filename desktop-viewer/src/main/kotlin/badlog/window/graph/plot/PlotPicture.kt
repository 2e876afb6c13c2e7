package badlog.window.graph.plot

import badlog.core.analysis.Span
import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.plot.Plot
import badlog.viewer.draw.plot.PlotAxis
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotLane
import badlog.viewer.draw.plot.PlotLine
import org.jetbrains.skia.Image

/**
 * A graph ready to be drawn: only pixels, with nothing left to calculate.
 *
 * @property request what it was made for.
 * @property axes the scales of y, one for each unit.
 * @property lines the lines of numbers.
 * @property lanes the lanes of states, below the lines.
 * @property image the drawn lines; null if there are none.
 * @property plotHeight the height of the lines, in pixels; the lanes have the rest.
 * @property plot the same for a pen.
 */
internal class PlotPicture(
    val request: PlotRequest,
    val axes: List<YAxis>,
    val lines: List<LinePicture>,
    val lanes: List<LanePicture>,
    val image: Image?,
    val plotHeight: Float,
) {
    val plot: Plot = Plot(
        PlotAxis.of(axes.map { it.axis }, axes.map { it.shown }) { lines[it].line.color },
        lines.map { PlotLine(it.line.color, it.strokes, it.axis) },
        lanes.map { lane -> PlotLane(laneName(lane.line, lanes.map { it.line }), lane.states, lane.blocks) },
        1 - plotHeight.toDouble() / request.height,
        request.spec.isFilled,
    )

    /** The frame for which it was made, at ([left], [top]). */
    fun frame(left: Double = 0.0, top: Double = 0.0): PlotFrame =
        PlotFrame(left, top, request.width.toDouble(), request.height.toDouble(), request.visible)
}

/** Returns the text beside the lane of [line], one of [all]: with several recordings, each has a lane with the same name. */
internal fun laneName(line: DrawnLine, all: List<DrawnLine>): String {
    val label = line.label?.take(MAX_LETTERS) ?: return line.title.take(MAX_LETTERS)
    return if (all.all { it.signal.name == line.signal.name }) label else "${line.title.take(MAX_LETTERS)} · $label"
}

/**
 * A scale of y.
 *
 * @property axis its unit and side.
 * @property fitted the range that the visible samples need.
 * @property shown the displayed range.
 * @property ticks the labeled places.
 */
internal class YAxis(val axis: GraphAxis, val fitted: Span, val shown: Span, val ticks: Ticks) {
    /** Returns where [value] is on a plot [height] pixels high, from its top. */
    fun pixelOf(value: Double, height: Float): Float {
        val pixel = (shown.to - value) / shown.width * height
        // Coordinates far outside the plot would be too large for drawing.
        return pixel.coerceIn(-MAX_DISTANCE * height, MAX_DISTANCE * height).toFloat()
    }

    /** Returns the value at [pixel] from the top of a plot [height] pixels high. */
    fun valueAt(pixel: Float, height: Float): Double = shown.to - pixel / height * shown.width

    private companion object {
        const val MAX_DISTANCE = 50.0
    }
}

/**
 * A line of numbers in pixels.
 *
 * @property axis which of the graph's scales it has.
 * @property strokes what is drawn, in pixels from the plot's top left corner.
 */
internal class LinePicture(val line: DrawnLine, val axis: Int, val strokes: Strokes)

/**
 * A lane of states in pixels.
 *
 * @property states what each number means.
 * @property blocks what is drawn, from left to right, the short ones last.
 */
internal class LanePicture(val line: DrawnLine, val states: List<String>, val blocks: LaneBlocks)

private const val MAX_LETTERS = 40
