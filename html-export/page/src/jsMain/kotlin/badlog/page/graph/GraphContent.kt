package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.PixelColumns
import badlog.page.view.Scene
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.range.holdsUntil
import badlog.viewer.choices.range.stateRuns
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.lane.LaneLook
import badlog.viewer.draw.plot.GraphLine
import badlog.viewer.draw.plot.Plot
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotLane
import badlog.viewer.draw.plot.PlotMargins
import badlog.viewer.draw.plot.dotAt
import badlog.viewer.draw.plot.plotOf

/**
 * The content of a graph's frame: the lines of [card], or its lanes of states. Lanes keep their places when they are hidden.
 *
 * @param look returns the current settings of the graph.
 */
internal class GraphContent(private val card: CardLines, private val scene: Scene, private val look: () -> BoardGraph) {
    private class Line(override val series: GraphSeries, override val color: Int) : GraphLine {
        val curve = Curve(series.data, series.holdsUntil)
        val strokes = Strokes()
    }

    private class Lane(val series: GraphSeries) {
        val runs = series.stateRuns()
        val blocks = LaneBlocks()
    }

    private val series = card.graph.series
    private val lines = if (card.graph.showsStates) emptyList() else series.mapIndexed { i, line -> Line(line, card.colors[i]) }
    private val lanes = if (card.graph.showsStates) series.map(::Lane) else emptyList()
    private var drawn = emptyList<Line>()

    /** The plot that was shown last. */
    var plot: Plot = Plot(emptyList(), emptyList(), emptyList(), laneShare = 0.0)
        private set

    /** The lines of [plot]. */
    val drawnLines: List<GraphLine> get() = drawn

    /** The height of the plot with its axis, in CSS pixels. */
    val height: Int = if (card.graph.showsStates) lanesHeight(card.graph) else look().height ?: GraphHeight.MEDIUM.pixels

    /**
     * Returns the plot visible in [frame], with as many points as [columns] need. It is valid until the next call.
     *
     * [ratio] is the number of frame pixels for each CSS pixel.
     */
    fun plotIn(frame: PlotFrame, columns: PixelColumns, ratio: Double): Plot {
        val now = look()
        val span = frame.shown
        drawn = lines.filterIndexed { i, _ -> card.isShown[i] }
        for (line in drawn) {
            line.curve.draw(span.from, span.to, columns)
            line.strokes.trace(line.curve, frame.x, Scale.NONE)
        }
        val shownLanes = lanes.mapIndexed { i, lane ->
            val blocks = lane.blocks.takeIf { card.isShown[i] }?.apply { place(lane.runs, span, frame.width, ratio) }
            PlotLane(lane.series.name, lane.series.states.orEmpty(), blocks)
        }
        val shared = if (now.sharesY) scene.sharedY.seen else emptyMap()
        plot = plotOf(now, drawn, drawn.map { it.strokes }, shownLanes, frame, ratio, shared)
        return plot
    }

    /** Returns the place in [frame] of a cursor's dot at [x] on the line [index]; null if there is none. */
    fun dotAt(index: Int, x: Double, frame: PlotFrame): Pair<Double, Double>? {
        val line = lines.getOrNull(index) ?: return null
        val place = drawn.indexOf(line)
        return if (place < 0) null else plot.dotAt(place, line, x, frame)
    }
}

/** Returns the height of the plot and axis of [graph], which shows states, in CSS pixels. */
internal fun lanesHeight(graph: Graph): Int = LaneLook.HEIGHT * graph.series.size + PlotMargins.HEIGHT
