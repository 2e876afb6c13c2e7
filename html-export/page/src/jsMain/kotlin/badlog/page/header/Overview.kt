package badlog.page.header

import badlog.page.dom.EscapeKey
import badlog.page.dom.ResizeObserver
import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.pen.CanvasPen
import badlog.page.view.Scene
import badlog.page.view.findingText
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.drawEventMarks
import badlog.viewer.draw.plot.drawFindingMarks
import badlog.viewer.draw.plot.drawModes
import badlog.viewer.draw.plot.drawNoteMarks
import badlog.viewer.input.OverviewDrag
import badlog.viewer.input.OverviewGrip
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement
import org.w3c.dom.pointerevents.PointerEvent

/**
 * The whole recording as a strip, with its modes, events and findings, and the visible part. Dragging moves that
 * part or one of its edges, or selects a new part.
 */
internal class Overview(private val scene: Scene) {
    private lateinit var marks: HTMLCanvasElement
    private lateinit var visible: HTMLElement
    private lateinit var cursor: HTMLElement
    private lateinit var second: HTMLElement
    private val full = scene.range.full
    private var drag: OverviewDrag? = null
    private val escape = EscapeKey(::giveUp)

    val element: HTMLElement = element("div", "overview") {
        setAttribute("aria-hidden", "true")
        marks = add("canvas", "overview-marks").unsafeCast<HTMLCanvasElement>()
        visible = add("div", "overview-visible")
        cursor = add("div", "overview-cursor")
        second = add("div", "overview-cursor is-second")
        addEventListener("pointerdown", { press(it.unsafeCast<PointerEvent>()) })
        addEventListener("pointermove", { move(it.unsafeCast<PointerEvent>()) })
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

    /** Draws the marks of the events and findings, in the current colors. */
    fun drawMarks() {
        val ratio = window.devicePixelRatio
        val width = element.clientWidth * ratio
        val height = element.clientHeight * ratio
        marks.width = width.toInt()
        marks.height = height.toInt()
        val context = marks.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
        val frame = PlotFrame(0.0, 0.0, width, height, full)
        val colors = scene.palette.colors
        val shown = scene.marks
        with(CanvasPen(context)) {
            drawModes(frame, shown.modes, colors, hasNames = true)
            drawFindingMarks(frame, scene.findings, colors)
            drawEventMarks(frame, shown.events, colors)
            drawNoteMarks(frame, shown.notes, colors)
        }
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

    private fun xAt(event: PointerEvent): Double {
        val box = element.getBoundingClientRect()
        return (full.from + (event.clientX - box.left) / box.width * full.width).coerceIn(full.from, full.to)
    }

    private fun press(event: PointerEvent) {
        if (event.button.toInt() != 0) return
        element.setPointerCapture(event.pointerId)
        escape.take()
        drag = OverviewDrag(scene.range.viewport, xAt(event), full.width / element.clientWidth)
    }

    private fun move(event: PointerEvent) {
        val x = xAt(event)
        val going = drag
        if (going == null) {
            element.title = findingText(scene.findings.at(x, full.width * REACH), x)
            val grip = OverviewGrip.at(x, scene.range.viewport, full.width / element.clientWidth)
            element.style.cursor = CURSORS[grip.ordinal]
        } else {
            scene.range.change { going.movedTo(x) }
        }
    }

    private fun release(event: PointerEvent) {
        val ended = drag ?: return
        val x = xAt(event)
        if (!ended.hasMoved) {
            scene.range.change { ended.clicked(x) }
            scene.cursor.change { pinnedAt(x) }
        }
        stop()
    }

    private fun giveUp() {
        drag?.let { given -> scene.range.change { given.before } }
        stop()
    }

    private fun stop() {
        escape.giveBack()
        drag = null
    }

    private companion object {
        /** The mouse pointer over each handle. */
        val CURSORS = listOf("ew-resize", "ew-resize", "grab", "crosshair")

        /** The maximum distance between the pointer and a mark that it points at, as a fraction of the strip. */
        const val REACH = 0.005
    }
}
