package badlog.viewer.graph.plot

import badlog.analysis.Span
import badlog.plot.axis.GraphAxis
import badlog.plot.axis.Ticks
import badlog.plot.curve.Strokes
import badlog.plot.lane.LaneBlocks
import org.jetbrains.skia.Image

/**
 * A graph ready to be drawn: only pixels, nothing to be found out any more.
 *
 * @property request what it was made for.
 * @property axes the scales of y, one for each unit.
 * @property lines the lines of numbers.
 * @property lanes the lanes of states, below the lines.
 * @property image the lines as they are to be seen; null without any.
 * @property plotHeight how much of the height the lines have, in pixels; the lanes have the rest.
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
 * @property axis its unit, and where it stands.
 * @property fitted what the visible samples need.
 * @property shown what is seen of it.
 * @property ticks the places that are labeled.
 */
internal class YAxis(val axis: GraphAxis, val fitted: Span, val shown: Span, val ticks: Ticks) {
    /** Where [value] stands on a plot [height] pixels high, from its top. */
    fun pixelOf(value: Double, height: Float): Float {
        val pixel = (shown.to - value) / shown.width * height
        // Numbers far out of sight would be too large to draw with.
        return pixel.coerceIn(-MAX_DISTANCE * height, MAX_DISTANCE * height).toFloat()
    }

    /** The value at [pixel] from the top of a plot [height] pixels high. */
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
