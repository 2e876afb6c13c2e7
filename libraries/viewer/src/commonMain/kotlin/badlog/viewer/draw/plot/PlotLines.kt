package badlog.viewer.draw.plot

import badlog.core.analysis.Span
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.lane.LaneBlocks

/**
 * A line of numbers, ready for drawing.
 *
 * @property color the index of the line's color, from 0.
 * @property strokes the strokes and dots, in physical pixels.
 * @property axis the index of the line's y axis.
 */
class PlotLine(val color: Int, val strokes: Strokes, val axis: Int)

/**
 * A y axis, ready for drawing.
 *
 * @property shown the visible part of y.
 * @property color the index of the color of its numbers, if there are other axes and it has a single line; null for the color of other
 *   texts.
 */
class PlotAxis(val side: AxisSide, val unit: String, val shown: Span, val color: Int?) {
    companion object {
        /** Returns [axes] with their [limits], for lines with these [colors]. */
        fun of(axes: List<GraphAxis>, limits: List<Span>, colors: (Int) -> Int): List<PlotAxis> = axes.mapIndexed { i, axis ->
            PlotAxis(axis.side, axis.unit, limits[i], if (axes.size > 1) axis.lines.singleOrNull()?.let(colors) else null)
        }
    }
}

/**
 * A lane of states, ready for drawing.
 *
 * @property states the name of each state.
 * @property blocks the blocks, in physical pixels from the left of the frame; null if the lane is hidden, but keeps its place.
 */
class PlotLane(val name: String, val states: List<String>, val blocks: LaneBlocks?)
