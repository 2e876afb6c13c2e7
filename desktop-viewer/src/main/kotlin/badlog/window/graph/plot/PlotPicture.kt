package badlog.window.graph.plot

import badlog.core.analysis.Span
import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.lane.LaneBlocks
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
 */
internal class PlotPicture(
    val request: PlotRequest,
    val axes: List<YAxis>,
    val lines: List<LinePicture>,
    val lanes: List<LanePicture>,
    val image: Image?,
    val plotHeight: Float,
)

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
