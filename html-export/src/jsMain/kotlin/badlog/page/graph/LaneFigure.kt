package badlog.page.graph

import badlog.analysis.Graph
import badlog.analysis.PixelColumns
import badlog.page.view.Palette
import badlog.page.view.VisibleRange
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D

/** States as lanes of coloured blocks over x, each with its text where that fits. */
internal class LaneFigure(
    private val graph: Graph,
    private val palette: Palette,
    private val isShown: BooleanArray,
    end: Double,
) : Figure {
    private val runs = graph.series.map { StateRuns(it.data, end) }
    private var span = VisibleRange.Span(0.0, 1.0)

    override val height: Int get() = LANE_HEIGHT * graph.series.size + AXIS_HEIGHT
    override val limits: YLimits = YLimits()
    override val hasYAxis: Boolean get() = false

    override fun lines(frameOf: (UPlot) -> PlotFrame): List<dynamic> = emptyList()

    override fun prepare(span: VisibleRange.Span, columns: PixelColumns) {
        this.span = span
    }

    override fun style(plot: UPlot) = Unit

    override fun heightAt(index: Int, x: Double): Double = Double.NaN

    override fun draw(context: CanvasRenderingContext2D, frame: PlotFrame) {
        val ratio = window.devicePixelRatio
        val lane = frame.height / runs.size
        context.save()
        context.beginPath()
        context.rect(frame.left, frame.top, frame.width, frame.height)
        context.clip()
        context.font = "${LETTERS * ratio}px system-ui, sans-serif"
        context.asDynamic().textBaseline = "middle"
        context.asDynamic().textAlign = "left"
        runs.forEachIndexed { index, run ->
            if (isShown[index]) drawLane(context, frame, index, run, frame.top + lane * index, lane - GAP * ratio)
        }
        context.restore()
    }

    private fun drawLane(
        context: CanvasRenderingContext2D,
        frame: PlotFrame,
        series: Int,
        run: StateRuns,
        top: Double,
        height: Double,
    ) {
        val ratio = window.devicePixelRatio
        val names = graph.series[series].states.orEmpty()
        var drawnTo = frame.left - 1
        for (i in run.firstReaching(span.from) until run.states.size) {
            if (run.from[i] > span.to) {
                if (graph.series[series].data.isOrdered) break else continue
            }
            val left = maxOf(frame.pixelOfX(run.from[i]), frame.left)
            val right = minOf(maxOf(frame.pixelOfX(run.to[i]), left + 1), frame.right)
            // Thousands of changes in one pixel look the same as one of them.
            if (right <= drawnTo + 1 && right - left <= 1) continue
            drawnTo = right
            context.fillStyle = colourOf(run.states[i], names)
            context.fillRect(left, top, right - left, height)
            drawName(context, names.getOrElse(run.states[i]) { "?" }, left, right, top + height / 2, ratio)
        }
    }

    private fun drawName(
        context: CanvasRenderingContext2D,
        name: String,
        left: Double,
        right: Double,
        middle: Double,
        ratio: Double,
    ) {
        val room = right - left - 2 * MARGIN * ratio
        if (room < LETTERS * ratio) return
        val letters = (room / (LETTERS * ratio * LETTER_SHARE)).toInt()
        val fits = name.length < letters || context.measureText(name).width <= room
        val text = if (fits) name else name.take(maxOf(1, letters - 1)) + "…"
        context.fillStyle = palette.stateText
        context.fillText(text, left + MARGIN * ratio, middle)
    }

    // False is the quiet one: where a switch is pressed has to be seen at a glance.
    private fun colourOf(state: Int, names: List<String>) =
        if (names.size == 2 && names[0] == "false" && state == 0) palette.off else palette.state(state)

    private companion object {
        const val LANE_HEIGHT = 30
        const val AXIS_HEIGHT = 38
        const val GAP = 3
        const val LETTERS = 11
        const val LETTER_SHARE = 0.58
        const val MARGIN = 5
    }
}
