package badlog.page.graph

import badlog.analysis.Graph
import badlog.analysis.PixelColumns
import badlog.analysis.Span
import badlog.analysis.StateRuns
import badlog.page.view.Palette
import badlog.plot.axis.YLimits
import badlog.plot.lane.LaneBlock
import badlog.plot.lane.laneBlocks
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import kotlin.math.ceil

/** States as lanes of coloured blocks over x, each with its text where that fits. */
internal class LaneFigure(private val graph: Graph, private val palette: Palette, private val isShown: BooleanArray, end: Double) :
    Figure {
    private val runs = graph.series.map { StateRuns(it.data, end) }
    private var span = Span(0.0, 1.0)

    override val height: Int get() = LANE_HEIGHT * graph.series.size + AXIS_HEIGHT
    override val limits: YLimits = YLimits()
    override val hasYAxis: Boolean get() = false

    override fun lines(frameOf: (UPlot) -> PlotFrame): List<dynamic> = emptyList()

    override fun prepare(span: Span, columns: PixelColumns) {
        this.span = span
    }

    override fun style(plot: UPlot) = Unit

    override fun heightAt(index: Int, x: Double): Double = Double.NaN

    override fun draw(context: CanvasRenderingContext2D, frame: PlotFrame) {
        val ratio = window.devicePixelRatio
        val lane = frame.height / runs.size
        context.save()
        context.translate(frame.left, frame.top)
        context.beginPath()
        context.rect(0.0, 0.0, frame.width, frame.height)
        context.clip()
        context.font = "${LETTERS * ratio}px system-ui, sans-serif"
        context.asDynamic().textBaseline = "middle"
        context.asDynamic().textAlign = "left"
        runs.forEachIndexed { index, run ->
            if (!isShown[index]) return@forEachIndexed
            val names = graph.series[index].states.orEmpty()
            for (block in laneBlocks(run, span, frame.width, ceil(SHORTEST * ratio).toInt())) {
                drawBlock(context, block, names, lane * index, lane - GAP * ratio)
            }
        }
        context.restore()
    }

    private fun drawBlock(context: CanvasRenderingContext2D, block: LaneBlock, names: List<String>, top: Double, height: Double) {
        // The quiet colours let through what is below them, as the longer block that a short one interrupts.
        context.clearRect(block.left, top, block.width, height)
        context.fillStyle = colourOf(block, names)
        context.fillRect(block.left, top, block.width, height)
        drawName(context, block, names.getOrElse(block.state) { "?" }, top + height / 2)
    }

    private fun drawName(context: CanvasRenderingContext2D, block: LaneBlock, name: String, middle: Double) {
        val ratio = window.devicePixelRatio
        val room = block.width - 2 * MARGIN * ratio
        if (room < LETTERS * ratio) return
        val letters = (room / (LETTERS * ratio * LETTER_SHARE)).toInt()
        val fits = name.length < letters || context.measureText(name).width <= room
        // A few letters of a name say nothing, or what another state is called.
        if (!fits && letters <= FEWEST_LETTERS) return
        context.fillStyle = palette.stateText
        context.fillText(if (fits) name else name.take(letters - 1) + "…", block.left + MARGIN * ratio, middle)
    }

    private fun colourOf(block: LaneBlock, names: List<String>) = when {
        // False is the quiet one: where a switch is pressed has to be seen at a glance.
        names.size == 2 && names[0] == "false" && block.state == 0 -> palette.off

        // And nobody sees a few pixels of a colour that is quiet enough for text.
        block.width < NARROW * window.devicePixelRatio -> palette.line(block.state)

        else -> palette.state(block.state)
    }

    private companion object {
        const val LANE_HEIGHT = 30
        const val AXIS_HEIGHT = 38
        const val GAP = 3

        /** The width of the shortest state, in pixels of the page. */
        const val SHORTEST = 1.5
        const val NARROW = 4
        const val FEWEST_LETTERS = 6
        const val LETTERS = 11
        const val LETTER_SHARE = 0.58
        const val MARGIN = 5
    }
}
