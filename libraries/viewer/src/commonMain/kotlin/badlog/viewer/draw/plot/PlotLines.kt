package badlog.viewer.draw.plot

import badlog.core.analysis.Span
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.lane.LaneBlocks

/**
 * A line of numbers, ready to be drawn.
 *
 * @property color the index of its color, from 0.
 * @property strokes its strokes and dots, in physical pixels.
 * @property axis the index of its y axis.
 */
class PlotLine(val color: Int, val strokes: Strokes, val axis: Int)

/**
 * A y axis, ready to be drawn.
 *
 * @property shown the part of y that it shows.
 * @property color the index of the color of its numbers, that of its only line beside other axes; null for the color of all other texts.
 */
class PlotAxis(val side: AxisSide, val unit: String, val shown: Span, val color: Int?) {
    companion object {
        /** Returns [axes], which show [limits], of lines with these [colors]. */
        fun of(axes: List<GraphAxis>, limits: List<Span>, colors: (Int) -> Int): List<PlotAxis> = axes.mapIndexed { i, axis ->
            PlotAxis(axis.side, axis.unit, limits[i], if (axes.size > 1) axis.lines.singleOrNull()?.let(colors) else null)
        }
    }
}

/**
 * A lane of states, ready to be drawn.
 *
 * @property states the name of each state.
 * @property blocks its blocks, in physical pixels from the left of the frame; null if it is hidden, but keeps its place.
 */
class PlotLane(val name: String, val states: List<String>, val blocks: LaneBlocks?)
