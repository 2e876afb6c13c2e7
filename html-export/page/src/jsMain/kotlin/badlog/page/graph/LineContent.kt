package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.page.view.Scene
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.range.holdsUntil
import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.axis.axisLimits
import badlog.viewer.draw.axis.graphAxes
import badlog.viewer.draw.axis.limitsFor
import badlog.viewer.draw.axis.seenTogether
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.plot.Plot
import badlog.viewer.draw.plot.PlotAxis
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotLine
import badlog.viewer.shown.cursor.indexAt

/**
 * Numbers as lines over x, with a separate axis for each unit.
 *
 * @param colors the index of each line's color.
 * @param isShown for each series, whether its line is drawn; the legend changes it.
 * @param look the current settings of the graph.
 */
internal class LineContent(
    private val graph: Graph,
    private val colors: List<Int>,
    private val scene: Scene,
    private val isShown: BooleanArray,
    private val look: () -> BoardGraph,
) : PlotContent {
    private val curves = graph.series.map { Curve(it.data, it.holdsUntil) }
    private val strokes = curves.map { Strokes() }
    private val axisOf = IntArray(curves.size)

    override val height: Int = look().height ?: GraphHeight.MEDIUM.pixels
    override var limits: List<Span> = emptyList()
        private set

    override fun plotIn(frame: PlotFrame, columns: PixelColumns, ratio: Double): Plot {
        val span = frame.shown
        curves.forEachIndexed { index, curve -> if (isShown[index]) curve.draw(span.from, span.to, columns) }
        val axes = graphAxes(graph.series.mapIndexed { index, series -> series.unit.takeIf { isShown[index] } })
        axes.forEachIndexed { i, axis -> for (line in axis.lines) axisOf[line] = i }
        val now = look()
        limits = axisLimits(axes, axes.map { wholeOf(it, now) }, now.yRange, now.rightYRange)
        val lines = curves.indices.filter { isShown[it] }.map { index ->
            strokes[index].trace(curves[index], frame.x, frame.scaleOf(limits[axisOf[index]]))
            PlotLine(colors[index], strokes[index], axisOf[index])
        }
        return Plot(PlotAxis.of(axes, limits, colors::get), lines, emptyList(), laneShare = 0.0, graph.isFilled)
    }

    private fun wholeOf(axis: GraphAxis, now: BoardGraph): Span {
        val own = axis.lines.map { SeenOfUnit(axis.unit, curves[it].min, curves[it].max) }
        val shared = if (now.sharesY) scene.sharedY.seen(axis.unit) else null
        val seen = shared ?: seenTogether(own)[axis.unit]
        return limitsFor(seen?.least ?: Double.NaN, seen?.most ?: Double.NaN, graph.includesZero)
    }

    override fun heightAt(index: Int, x: Double): Double {
        val series = graph.series[index]
        val sample = series.indexAt(x)
        if (!isShown[index] || sample < 0) return Double.NaN
        val shown = limits[axisOf[index]]
        return (shown.to - series.data.y[sample]) / shown.width
    }
}
