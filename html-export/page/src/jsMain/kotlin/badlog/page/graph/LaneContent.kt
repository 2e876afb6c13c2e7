package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns
import badlog.page.view.Palette
import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.lane.LaneLook
import badlog.viewer.draw.lane.LaneTone
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import kotlin.math.ceil

/** States as lanes of colored blocks over x, each with its text where that fits. */
internal class LaneContent(private val graph: Graph, private val palette: Palette, private val isShown: BooleanArray, end: Double) :
    PlotContent {
    private val runs = graph.series.map { StateRuns(it.data, end) }
    private val blocks = LaneBlocks()
    private var span = Span(0.0, 1.0)

    override val isOpaque: Boolean get() = true
    override val height: Int get() = heightOf(graph)
    override val axes: List<GraphAxis> get() = emptyList()
    override val limits: List<Span> get() = emptyList()

    override fun prepare(span: Span, columns: PixelColumns) {
        this.span = span
    }

    override fun heightAt(index: Int, x: Double): Double = Double.NaN

    override fun draw(context: CanvasRenderingContext2D, frame: PlotFrame) {
        val ratio = window.devicePixelRatio
        val lane = frame.height / runs.size
        context.save()
        context.translate(frame.left, frame.top)
        context.beginPath()
        context.rect(0.0, 0.0, frame.width, frame.height)
        context.clip()
        context.font = "${LaneLook.LETTERS * ratio}px system-ui, sans-serif"
        context.asDynamic().textBaseline = "middle"
        context.asDynamic().textAlign = "left"
        runs.forEachIndexed { index, run ->
            if (!isShown[index]) return@forEachIndexed
            blocks.place(run, span, frame.width, ceil(LaneLook.MIN_BLOCK * ratio).toInt())
            val names = graph.series[index].states.orEmpty()
            for (block in 0 until blocks.size) drawBlock(context, block, names, lane * index, lane - GAP * ratio)
        }
        context.restore()
        if (runs.size > 1) drawLaneNames(context, frame, lane)
    }

    /** Draws the names of the lanes at their left, or as much of them as fits. */
    private fun drawLaneNames(context: CanvasRenderingContext2D, frame: PlotFrame, lane: Double) {
        val ratio = window.devicePixelRatio
        val room = frame.left - 2 * LaneLook.MARGIN * ratio
        context.save()
        context.font = "${LaneLook.LETTERS * ratio}px system-ui, sans-serif"
        context.asDynamic().textBaseline = "middle"
        context.asDynamic().textAlign = "right"
        context.fillStyle = palette[Shade.MUTED]
        graph.series.forEachIndexed { index, series ->
            var letters = series.name.length
            fun shown() = if (letters == series.name.length) series.name else series.name.take(letters) + "…"
            while (letters > 1 && context.measureText(shown()).width > room) letters--
            context.fillText(shown(), frame.left - LaneLook.MARGIN * ratio, frame.top + lane * (index + 0.5))
        }
        context.restore()
    }

    private fun drawBlock(context: CanvasRenderingContext2D, block: Int, names: List<String>, top: Double, height: Double) {
        val left = blocks.left[block]
        val width = blocks.right[block] - left
        val state = blocks.states[block]
        // The muted colors are translucent, so the longer block that a short one interrupts would show through.
        context.clearRect(left, top, width, height)
        context.fillStyle = when (LaneTone.of(names, state, width / window.devicePixelRatio)) {
            LaneTone.OFF -> palette[Shade.STATE_OFF]
            LaneTone.QUIET -> palette.state(state)
            LaneTone.STRONG -> palette.line(state)
        }
        context.fillRect(left, top, width, height)
        drawName(context, left, width, names.getOrElse(state) { "?" }, top + height / 2)
    }

    private fun drawName(context: CanvasRenderingContext2D, left: Double, width: Double, name: String, middle: Double) {
        val ratio = window.devicePixelRatio
        val room = width - 2 * LaneLook.MARGIN * ratio
        if (!LaneLook.hasRoom(room / ratio, isWhole = true)) return
        val letters = (room / (LaneLook.LETTERS * ratio * LETTER_SHARE)).toInt()
        val fits = name.length < letters || context.measureText(name).width <= room
        if (!LaneLook.hasRoom(room / ratio, isWhole = fits)) return
        context.fillStyle = palette[Shade.STATE_TEXT]
        context.fillText(if (fits) name else name.take(letters - 1) + "…", left + LaneLook.MARGIN * ratio, middle)
    }

    internal companion object {
        /** Returns the height of the plot of [graph] with its axis, in CSS pixels. */
        fun heightOf(graph: Graph): Int = LaneLook.HEIGHT * graph.series.size + Plot.MARGINS

        private const val GAP = 2
        private const val LETTER_SHARE = 0.58
    }
}
