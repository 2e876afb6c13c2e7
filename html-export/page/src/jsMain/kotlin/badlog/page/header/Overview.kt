package badlog.page.header

import badlog.page.dom.ResizeObserver
import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.input.PointerListener
import badlog.page.pen.CanvasPen
import badlog.page.view.Scene
import badlog.page.view.SceneTarget
import badlog.page.view.findingText
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.drawOverview
import badlog.viewer.input.PlotPointer
import badlog.viewer.session.gesture.OverviewGestures
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement

/**
 * The whole recording as a strip, with its modes, events and findings, and the visible part. Dragging moves the visible part or one of its
 * edges, or selects a new part.
 */
internal class Overview(private val scene: Scene) {
    private lateinit var marks: HTMLCanvasElement
    private lateinit var visible: HTMLElement
    private lateinit var cursor: HTMLElement
    private lateinit var second: HTMLElement
    private val full = scene.range.full
    private val gestures = OverviewGestures(SceneTarget(scene))

    val element: HTMLElement = element("div", "overview") {
        setAttribute("aria-hidden", "true")
        marks = add("canvas", "overview-marks").unsafeCast<HTMLCanvasElement>()
        visible = add("div", "overview-visible")
        cursor = add("div", "overview-cursor")
        second = add("div", "overview-cursor is-second")
    }

    init {
        PointerListener(element, gestures, onHover = ::point)
        ResizeObserver { drawMarks() }.observe(element)
        scene.range.onChange { update() }
        scene.cursor.onChange { update() }
        update()
    }

    /** Draws the marks of the events and findings, in the current colors. */
    fun drawMarks() {
        val ratio = window.devicePixelRatio
        val width = element.clientWidth * ratio
        val height = element.clientHeight * ratio
        marks.width = width.toInt()
        marks.height = height.toInt()
        val context = marks.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
        val frame = PlotFrame(0.0, 0.0, width, height, full)
        CanvasPen(context).drawOverview(frame, scene.marks, scene.palette.colors)
    }

    private fun update() {
        val now = scene.range.now
        visible.style.left = percent(now.from)
        visible.style.width = "${now.width / full.width * 100}%"
        visible.classList.toggle("is-all", !scene.range.isZoomed)
        place(cursor, scene.cursor.now.x)
        place(second, scene.cursor.now.second)
    }

    private fun place(line: HTMLElement, x: Double?) {
        line.isHidden = x == null
        if (x != null) line.style.left = percent(x)
    }

    private fun percent(x: Double) = "${(x - full.from) / full.width * 100}%"

    /** Shows the effect of a drag, and the findings under the pointer. */
    private fun point(at: PlotPointer) {
        val x = gestures.placeAt(at)
        element.title = findingText(scene.findings.at(x, full.width * REACH), x)
        element.style.cursor = CURSORS[gestures.gripAt(at).ordinal]
    }

    private companion object {
        /** The mouse pointer over each handle. */
        val CURSORS = listOf("ew-resize", "ew-resize", "grab", "crosshair")

        /** The maximum distance between the pointer and the mark under it, as a fraction of the strip. */
        const val REACH = 0.005
    }
}
