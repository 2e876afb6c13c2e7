package badlog.page.section

import badlog.analysis.Span
import badlog.page.dom.EscapeKey
import badlog.page.dom.ResizeObserver
import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.graph.PlotFrame
import badlog.page.graph.drawEventMarks
import badlog.page.graph.drawFindingMarks
import badlog.page.view.Scene
import badlog.page.view.findingText
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement
import org.w3c.dom.pointerevents.PointerEvent
import kotlin.math.abs

/**
 * The whole recording as a strip, with its events and findings and the part that is visible; dragging moves that part, or chooses
 * one.
 */
internal class Overview(private val scene: Scene) {
    private lateinit var marks: HTMLCanvasElement
    private lateinit var visible: HTMLElement
    private lateinit var cursor: HTMLElement
    private val full = scene.range.full
    private var grip = Double.NaN
    private var anchor = Double.NaN
    private var startX = 0.0
    private var startSpan = full
    private val escape = EscapeKey(::giveUp)

    val element: HTMLElement = element("div", "overview") {
        setAttribute("aria-hidden", "true")
        marks = add("canvas", "overview-marks").unsafeCast<HTMLCanvasElement>()
        visible = add("div", "overview-visible")
        cursor = add("div", "overview-cursor")
        addEventListener("pointerdown", { press(it.unsafeCast<PointerEvent>()) })
        addEventListener("pointermove", { drag(it.unsafeCast<PointerEvent>()) })
        addEventListener("pointerup", { release(it.unsafeCast<PointerEvent>()) })
        addEventListener("pointercancel", { stop() })
        addEventListener("dblclick", { scene.range.change { reset() } })
    }

    init {
        ResizeObserver { drawMarks() }.observe(element)
        scene.range.onChange { update() }
        scene.cursor.onChange { update() }
        update()
    }

    /** Draws the marks of the events and findings, in the colours of now. */
    fun drawMarks() {
        val ratio = window.devicePixelRatio
        val width = element.clientWidth * ratio
        val height = element.clientHeight * ratio
        marks.width = width.toInt()
        marks.height = height.toInt()
        val context = marks.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
        val frame = PlotFrame(0.0, 0.0, width, height, full.from, full.to, 0.0, 1.0)
        drawFindingMarks(context, frame, scene, full)
        drawEventMarks(context, frame, scene, full)
    }

    private fun update() {
        val now = scene.range.now
        visible.style.left = percent(now.from)
        visible.style.width = "${now.width / full.width * 100}%"
        visible.classList.toggle("is-all", !scene.range.isZoomed)
        cursor.isHidden = !scene.cursor.isPlaced
        if (scene.cursor.isPlaced) cursor.style.left = percent(scene.cursor.x)
    }

    private fun percent(x: Double) = "${(x - full.from) / full.width * 100}%"

    private fun xAt(event: PointerEvent): Double {
        val box = element.getBoundingClientRect()
        return (full.from + (event.clientX - box.left) / box.width * full.width).coerceIn(full.from, full.to)
    }

    private fun press(event: PointerEvent) {
        if (event.button.toInt() != 0) return
        element.setPointerCapture(event.pointerId)
        val x = xAt(event)
        val now = scene.range.now
        startX = event.clientX.toDouble()
        startSpan = now
        escape.take()
        if (scene.range.isZoomed && x in now.from..now.to) grip = x - now.from else anchor = x
    }

    private fun drag(event: PointerEvent) {
        if (grip.isNaN() && anchor.isNaN()) {
            element.title = findingText(scene.findings.at(xAt(event), full.width * REACH))
            return
        }
        if (!startX.isNaN()) {
            if (abs(event.clientX - startX) < FEWEST_PIXELS) return
            startX = Double.NaN
            scene.range.change { remembered() }
        }
        val x = xAt(event)
        if (!anchor.isNaN()) scene.range.change { moved(anchor, x) } else moveTo(x - grip)
    }

    private fun release(event: PointerEvent) {
        // A click beside the visible part brings that part here.
        val isClick = !startX.isNaN()
        if (isClick && !anchor.isNaN()) {
            val now: Span = scene.range.now
            if (scene.range.isZoomed) scene.range.change { remembered() }
            moveTo(xAt(event) - now.width / 2)
            scene.cursor.place(xAt(event))
        }
        stop()
    }

    private fun moveTo(from: Double) = scene.range.change { moved(from, from + visible.width) }

    private fun giveUp() {
        scene.range.change { moved(startSpan.from, startSpan.to) }
        stop()
    }

    private fun stop() {
        escape.giveBack()
        grip = Double.NaN
        anchor = Double.NaN
    }

    private companion object {
        const val FEWEST_PIXELS = 3.0

        /** Which part of the strip may lie between the pointer and a mark that it points at. */
        const val REACH = 0.005
    }
}
