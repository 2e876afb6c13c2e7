package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.page.view.Scene
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.axis.axisLimits
import badlog.viewer.draw.axis.graphAxes
import badlog.viewer.draw.axis.limitsFor
import badlog.viewer.draw.axis.seenTogether
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.shown.cursor.indexAt
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D

/**
 * Numbers as lines over x, with a separate axis for each unit.
 *
 * @param isShown for each series, whether its line is drawn; the legend changes it.
 * @param look the current settings of the graph.
 */
internal class LineContent(
    private val graph: Graph,
    private val scene: Scene,
    private val isShown: BooleanArray,
    private val look: () -> BoardGraph,
) : PlotContent {
    private val palette = scene.palette
    private val curves = graph.series.map { Curve(it.data, if (it.holds) scene.range.full.to else null) }
    private val strokes = curves.map { Strokes() }
    private val axisOf = IntArray(curves.size)

    override val isOpaque: Boolean get() = false
    override val height: Int = look().height ?: GraphHeight.MEDIUM.pixels
    override var axes: List<GraphAxis> = emptyList()
        private set
    override var limits: List<Span> = emptyList()
        private set

    override fun prepare(span: Span, columns: PixelColumns) {
        curves.forEachIndexed { index, curve -> if (isShown[index]) curve.draw(span.from, span.to, columns) }
        axes = graphAxes(graph.series.mapIndexed { index, series -> series.unit.takeIf { isShown[index] } })
        axes.forEachIndexed { i, axis -> for (line in axis.lines) axisOf[line] = i }
        val now = look()
        limits = axisLimits(axes, axes.map { wholeOf(it, now) }, now.yRange, now.rightYRange)
    }

    private fun wholeOf(axis: GraphAxis, now: BoardGraph): Span {
        val own = axis.lines.map { SeenOfUnit(axis.unit, curves[it].min, curves[it].max) }
        val shared = if (now.sharesY) scene.sharedY.seen(axis.unit) else null
        val seen = shared ?: seenTogether(own)[axis.unit]
        return limitsFor(seen?.least ?: Double.NaN, seen?.most ?: Double.NaN, graph.includesZero)
    }

    override fun draw(context: CanvasRenderingContext2D, frame: PlotFrame) {
        val ratio = window.devicePixelRatio
        context.save()
        context.beginPath()
        context.rect(frame.left, frame.top - LINE_WIDTH, frame.width, frame.height + 2 * LINE_WIDTH)
        context.clip()
        context.asDynamic().lineJoin = "round"
        forEachShown { index, curve ->
            val y = frame.scaleOf(limits[axisOf[index]])
            strokes[index].trace(curve, frame.x, y)
            if (graph.isFilled) {
                context.fillStyle = palette.line(index) + AREA_OPACITY
                drawAreas(context, strokes[index], frame.baselineOf(y))
            }
            context.strokeStyle = palette.line(index)
            // Strokes of up to one physical pixel are drawn many times faster than wider ones.
            context.lineWidth = if (curve.isDense) 1.0 else LINE_WIDTH * ratio
            drawLines(context, strokes[index])
        }
        context.restore()
        forEachShown { index, curve ->
            context.fillStyle = palette.line(index)
            drawDots(context, strokes[index], frame, ratio * if (curve.isSparse) DOT_RADIUS else LONE_RADIUS)
        }
        val right = axes.indexOfFirst { it.side == AxisSide.RIGHT }
        if (right >= 0) drawRightAxis(context, frame, axes[right], limits[right], palette)
    }

    private inline fun forEachShown(work: (Int, Curve) -> Unit) {
        for (index in curves.indices) if (isShown[index]) work(index, curves[index])
    }

    override fun heightAt(index: Int, x: Double): Double {
        val series = graph.series[index]
        val sample = series.indexAt(x)
        if (!isShown[index] || sample < 0) return Double.NaN
        val shown = limits[axisOf[index]]
        return (shown.to - series.data.y[sample]) / shown.width
    }

    private companion object {
        const val LINE_WIDTH = 1.5
        const val DOT_RADIUS = 2.5
        const val LONE_RADIUS = 1.0
        const val AREA_OPACITY = "30"
    }
}
