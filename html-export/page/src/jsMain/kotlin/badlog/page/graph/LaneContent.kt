package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.viewer.choices.range.stateRuns
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.lane.LaneLook
import badlog.viewer.draw.plot.Plot
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotLane
import badlog.viewer.draw.plot.PlotMargins
import kotlin.math.ceil

/**
 * States as lanes: one below the other, each a sequence of blocks.
 *
 * @param isShown for each series, whether its lane is drawn; the legend changes it.
 */
internal class LaneContent(private val graph: Graph, private val isShown: BooleanArray) : PlotContent {
    private val runs = graph.series.map { it.stateRuns() }
    private val blocks = runs.map { LaneBlocks() }

    override val height: Int get() = heightOf(graph)
    override val limits: List<Span> get() = emptyList()

    override fun heightAt(index: Int, x: Double): Double = Double.NaN

    override fun plotIn(frame: PlotFrame, columns: PixelColumns, ratio: Double): Plot {
        val lanes = graph.series.mapIndexed { i, series ->
            val drawn = blocks[i].takeIf { isShown[i] }
            drawn?.place(runs[i], frame.shown, frame.width, ceil(LaneLook.MIN_BLOCK * ratio).toInt())
            PlotLane(series.name, series.states.orEmpty(), drawn)
        }
        return Plot(emptyList(), emptyList(), lanes, laneShare = 1.0)
    }

    internal companion object {
        /** Returns the height of the plot of [graph] with its axis, in CSS pixels. */
        fun heightOf(graph: Graph): Int = LaneLook.HEIGHT * graph.series.size + PlotMargins.HEIGHT
    }
}
