package badlog.page.graph

import badlog.analysis.PixelColumns
import badlog.analysis.Span
import badlog.page.dom.json
import badlog.page.view.Scene
import badlog.plot.axis.Ticks
import badlog.plot.color.Shade
import kotlinx.browser.window
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement

/**
 * One drawn graph: a canvas with a frame and axes, and [content] inside.
 *
 * @param onSize is called when [over] has got its size, and another one.
 */
internal class Plot(
    private val scene: Scene,
    private val content: PlotContent,
    host: HTMLElement,
    private var width: Int,
    private val onSize: () -> Unit,
) {
    private var columns = PixelColumns(1)
    private val uPlot: UPlot

    /** The element over the frame, which takes the pointer. */
    val over: HTMLElement get() = uPlot.over

    /** How wide the frame is, in pixels as they look. The browser would lay the whole page out to say it. */
    val frameWidth: Double get() = uPlot.bbox.width / window.devicePixelRatio

    /** How high it is. */
    val frameHeight: Double get() = uPlot.bbox.height / window.devicePixelRatio

    /** The picture. */
    val canvas: HTMLCanvasElement get() = uPlot.ctx.canvas

    init {
        prepare()
        val full = scene.range.full
        val lines = content.lines(::frameOf)
        val data = Array(lines.size + 1) { arrayOf<Double?>(null, null) }
        // The lines' paths come from the content; uPlot only has to know that there is something on either end.
        data[0] = arrayOf(full.from, full.to)
        uPlot = UPlot(options(lines), data, host)
        content.style(uPlot)
    }

    /** Draws what is visible now. */
    fun redraw() {
        prepare()
        content.style(uPlot)
        val now = scene.range.now
        uPlot.batch { uPlot.setScale("x", json("min" to now.from, "max" to now.to)) }
    }

    /** Draws at another width. */
    fun resize(newWidth: Int) {
        if (newWidth == width || newWidth < MIN_WIDTH) return
        width = newWidth
        prepare()
        uPlot.batch {
            uPlot.setSize(json("width" to width, "height" to content.height))
            val now = scene.range.now
            uPlot.setScale("x", json("min" to now.from, "max" to now.to))
        }
    }

    /** Gives back the canvas. */
    fun remove() = uPlot.destroy()

    /** What the axis at the left shows. */
    private val left: Span get() = content.limits.firstOrNull() ?: Span(0.0, 1.0)

    private fun prepare() {
        val pixels = maxOf(1, ((width - GUTTER - RIGHT) * window.devicePixelRatio).toInt())
        if (columns.count != pixels) columns = PixelColumns(pixels)
        content.prepare(scene.range.now, columns)
    }

    private fun frameOf(plot: UPlot): PlotFrame {
        val now = scene.range.now
        val box = plot.bbox
        return PlotFrame(box.left, box.top, box.width, box.height, now.from, now.to)
    }

    private fun drawGround(plot: UPlot) = drawModes(plot.ctx, frameOf(plot), scene)

    private fun draw(plot: UPlot) {
        val frame = frameOf(plot)
        content.draw(plot.ctx, frame)
        drawFindingMarks(plot.ctx, frame, scene)
        drawEventMarks(plot.ctx, frame, scene)
        drawNoteMarks(plot.ctx, frame, scene)
    }

    private fun options(lines: List<dynamic>): dynamic = json(
        "width" to width,
        "height" to content.height,
        "padding" to arrayOf(TOP, RIGHT, 0, 0),
        "legend" to json("show" to false),
        "cursor" to json("show" to false),
        "select" to json("show" to false),
        "scales" to json(
            "x" to json("time" to false, "range" to { arrayOf(scene.range.now.from, scene.range.now.to) }),
            "y" to json("range" to { arrayOf(left.from, left.to) }),
        ),
        "series" to (listOf<dynamic>(json()) + lines).toTypedArray(),
        "axes" to arrayOf(
            axis("x", X_AXIS_HEIGHT) { plot -> Ticks.ofX(scene.range.now, plot.bbox.width / window.devicePixelRatio) },
            axis("y", GUTTER) { plot ->
                Ticks.ofY(left, plot.bbox.height / window.devicePixelRatio)
            },
        ),
        "hooks" to json("drawClear" to arrayOf(::drawGround), "draw" to arrayOf(::draw), "setSize" to arrayOf(onSize)),
    )

    private fun axis(scale: String, size: Int, ticksOf: (UPlot) -> Ticks): dynamic {
        fun hasTicks() = scale == "x" || content.axes.isNotEmpty()
        return json(
            "scale" to scale,
            "size" to size,
            "gap" to 6,
            "font" to "11px system-ui, -apple-system, \"Segoe UI\", Roboto, sans-serif",
            "stroke" to {
                if (scale == "y" && content.axes.size > 1) axisColor(content.axes[0], scene.palette) else scene.palette[Shade.MUTED]
            },
            "grid" to json("show" to true, "stroke" to { scene.palette[Shade.GRID] }, "width" to 1),
            "ticks" to json("show" to false),
            "splits" to { plot: UPlot -> if (hasTicks()) ticksOf(plot).values.toTypedArray() else emptyArray() },
            "values" to { plot: UPlot -> if (hasTicks()) ticksOf(plot).texts.toTypedArray() else emptyArray() },
        )
    }

    internal companion object {
        // Every plot has the same margins, so that one place on x is one place on the screen in all of them.
        private const val GUTTER = 62
        private const val RIGHT = 14
        private const val TOP = 6
        private const val X_AXIS_HEIGHT = 26
        private const val MIN_WIDTH = 100

        /** How much of a plot's height is above and below its frame. */
        const val MARGINS = TOP + X_AXIS_HEIGHT
    }
}
