package badlog.viewer.draw.plot

import badlog.core.analysis.GraphSeries
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.axis.axisLimits
import badlog.viewer.draw.axis.graphAxes
import badlog.viewer.draw.axis.limitsFor
import badlog.viewer.draw.axis.seenOn
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.lane.LaneLook
import badlog.viewer.draw.pen.Pen
import badlog.viewer.shown.cursor.dotAt
import badlog.viewer.shown.cursor.indexAt

/** A line of numbers that a graph draws. */
interface GraphLine {
    /** The samples of the line. */
    val series: GraphSeries

    /** The index of the line's color, from 0. */
    val color: Int

    /** The number that is added to the line's x. */
    val offset: Double get() = 0.0
}

/**
 * Returns the plot of the graph [look] in [frame]. It has the graph's visible [lines], each on the axis of its unit, and [lanes] below. The
 * axes fit the visible samples of their lines, unless a person has selected a range.
 *
 * @param strokes the strokes of each of [lines], with y as logged. They are placed here, because a scale is known only when all its lines
 *   are known.
 * @param density the number of physical pixels per CSS pixel or dp.
 * @param shared the visible range of each unit in all graphs that share their y limits with this one.
 */
fun plotOf(
    look: BoardGraph,
    lines: List<GraphLine>,
    strokes: List<Strokes>,
    lanes: List<PlotLane>,
    frame: PlotFrame,
    density: Double,
    shared: Map<String, SeenOfUnit> = emptyMap(),
): Plot {
    val laneShare = laneShareOf(lanes.size, lines.isNotEmpty(), frame.height / density)
    val axes = graphAxes(lines.map { it.series.unit })
    val wholes = seenOn(axes, strokes).map { shared[it.unit] ?: it }.map { limitsFor(it.least, it.most, look.includesZero) }
    val limits = axisLimits(axes, wholes, look.yRange, look.rightYRange)
    val lineFrame = frame.part(0.0, 1 - laneShare)
    val placed = lines.mapIndexed { i, line ->
        val axis = axes.indexOfFirst { i in it.lines }
        strokes[i].place(lineFrame.scaleOf(limits[axis]))
        PlotLine(line.color, strokes[i], axis)
    }
    return Plot(PlotAxis.of(axes, limits) { lines[it].color }, placed, lanes, laneShare, look.isFilled)
}

/** Returns the fraction of [height], in CSS pixels or dp, that [lanes] lanes take: all of it without lines. */
private fun laneShareOf(lanes: Int, hasLines: Boolean, height: Double): Double = when {
    lanes == 0 -> 0.0
    hasLines -> minOf(lanes * LaneLook.HEIGHT / height, MAX_LANE_SHARE)
    else -> 1.0
}

/**
 * Returns the x and y in [frame] of the dot on [line] for a cursor at [x]. [index] is the line's index in this plot. Null if the dot is not
 * in the frame, or the line has no sample there.
 */
fun Plot.dotAt(index: Int, line: GraphLine, x: Double, frame: PlotFrame): Pair<Double, Double>? {
    val sample = line.series.indexAt(x - line.offset)
    if (sample < 0) return null
    val lineFrame = frame.part(0.0, 1 - laneShare)
    val left = frame.x.placeOf(line.series.dotAt(x - line.offset) + line.offset)
    val top = lineFrame.scaleOf(axes[lines[index].axis].shown).placeOf(line.series.data.y[sample])
    return if (left in frame.left..frame.right && top in lineFrame.top..lineFrame.bottom) left to top else null
}

/**
 * Draws a dot on each of [lines], which [plot] draws, where a cursor at [x] reads it. The dot is at the sample, or at the cursor if the
 * value holds.
 */
fun Pen.drawSamples(frame: PlotFrame, plot: Plot, lines: List<GraphLine>, x: Double, colors: PenColors) {
    if (x !in frame.shown) return
    lines.forEachIndexed { i, line -> plot.dotAt(i, line, x, frame)?.let { (left, top) -> drawSample(left, top, line.color, colors) } }
}

private const val MAX_LANE_SHARE = 0.5
