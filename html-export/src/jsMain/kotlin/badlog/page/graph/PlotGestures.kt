package badlog.page.graph

import badlog.page.dom.EscapeKey
import badlog.page.dom.add
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Scene
import kotlinx.browser.window
import org.w3c.dom.HTMLElement
import org.w3c.dom.events.Event
import org.w3c.dom.events.WheelEvent
import org.w3c.dom.pointerevents.PointerEvent
import kotlin.math.abs
import kotlin.math.exp

/**
 * What a mouse or fingers do over a plot. A mouse moves the cursor, drags out what to zoom to, or, with Shift, drags
 * the graphs along. Fingers set the cursor, drag, and pinch; a vertical swipe is the browser's, and scrolls the page.
 */
internal class PlotGestures(private val over: HTMLElement, private val scene: Scene) {
    private enum class Drag { NONE, SELECT, PAN }

    private val selection = over.add("div", "selection").apply { isHidden = true }
    private val range = scene.range
    private val pinch = Pinch(range, ::xAt)
    private val escape = EscapeKey(::giveUp)
    private var drag = Drag.NONE
    private var startSpan = range.now
    private var startX = 0.0
    private var lastX = 0.0
    private var hasMoved = false
    private var tappedAt = Double.NEGATIVE_INFINITY
    private var tappedX = 0.0
    private var wheeledAt = 0.0

    init {
        on("pointerdown") { press(it.unsafeCast<PointerEvent>()) }
        on("pointermove") { move(it.unsafeCast<PointerEvent>()) }
        on("pointerup") { release(it.unsafeCast<PointerEvent>()) }
        on("pointercancel") { cancel(it.unsafeCast<PointerEvent>()) }
        on("wheel") { wheel(it.unsafeCast<WheelEvent>()) }
    }

    private fun on(type: String, listener: (Event) -> Unit) = over.addEventListener(type, listener)

    /** Where the pixel [clientX] is on x, or would be if the plot went on beside its frame. */
    private fun xAt(clientX: Double): Double {
        val box = over.getBoundingClientRect()
        return range.now.from + (clientX - box.left) / box.width * range.now.width
    }

    /** The same within the frame: a drag ends at its edge. */
    private fun xWithin(clientX: Double): Double = xAt(clientX).coerceIn(range.now.from, range.now.to)

    private fun press(event: PointerEvent) {
        if (event.button.toInt() != 0) return
        over.setPointerCapture(event.pointerId)
        if (event.pointerType == TOUCH && pinch.press(event)) {
            stop()
            return
        }
        // A finger moves what it touches, as on a map; a mouse draws a frame around it.
        val pans = if (event.pointerType == TOUCH) range.isZoomed else event.shiftKey
        drag = if (pans) Drag.PAN else Drag.SELECT
        startX = event.clientX.toDouble()
        startSpan = range.now
        lastX = startX
        hasMoved = false
        escape.take()
    }

    private fun move(event: PointerEvent) {
        val x = event.clientX.toDouble()
        if (pinch.move(event)) return
        if (drag == Drag.NONE) {
            if (event.pointerType != TOUCH) scene.cursor.place(xAt(x))
            return
        }
        if (!hasMoved && abs(x - startX) < FEWEST_PIXELS) return
        if (!hasMoved && drag == Drag.PAN) range.change { remembered() }
        hasMoved = true
        if (drag == Drag.PAN) pan(x) else select(x)
    }

    private fun pan(x: Double) {
        val distance = xAt(lastX) - xAt(x)
        lastX = x
        range.change { shifted(distance) }
    }

    private fun select(x: Double) {
        val box = over.getBoundingClientRect()
        val from = (minOf(startX, x) - box.left).coerceIn(0.0, box.width)
        val to = (maxOf(startX, x) - box.left).coerceIn(0.0, box.width)
        selection.isHidden = false
        selection.style.transform = "translateX(${from}px)"
        selection.style.width = "${to - from}px"
        selection.showText("Δ " + scene.xText((to - from) / box.width * range.now.width))
        scene.cursor.place(xWithin(x))
    }

    private fun release(event: PointerEvent) {
        if (pinch.release(event)) return
        val x = event.clientX.toDouble()
        if (drag == Drag.SELECT && hasMoved) range.change { showing(xWithin(startX), xWithin(x)) }
        if (drag != Drag.NONE && !hasMoved) tap(x)
        stop()
    }

    private fun tap(x: Double) {
        val now = window.performance.now()
        if (now - tappedAt < DOUBLE_TAP_MILLISECONDS && abs(x - tappedX) < DOUBLE_TAP_PIXELS) {
            tappedAt = Double.NEGATIVE_INFINITY
            range.change { reset() }
        } else {
            tappedAt = now
            tappedX = x
            scene.cursor.place(xAt(x))
        }
    }

    private fun cancel(event: PointerEvent) {
        pinch.release(event)
        stop()
    }

    private fun giveUp() {
        if (drag == Drag.PAN) range.change { moved(startSpan.from, startSpan.to) }
        stop()
    }

    private fun stop() {
        escape.giveBack()
        drag = Drag.NONE
        selection.isHidden = true
    }

    private fun wheel(event: WheelEvent) {
        val zooms = event.ctrlKey || event.asDynamic().metaKey == true
        val pans = !zooms && range.isZoomed && abs(event.deltaX) > abs(event.deltaY)
        if (!zooms && !pans) return
        event.preventDefault()
        val now = window.performance.now()
        if (now - wheeledAt > WHEEL_PAUSE_MILLISECONDS) range.change { remembered() }
        wheeledAt = now
        val lines = if (event.deltaMode == WheelEvent.DOM_DELTA_LINE) PIXELS_OF_LINE else 1.0
        if (zooms) {
            val factor = exp((event.deltaY * lines).coerceIn(-60.0, 60.0) * WHEEL_SPEED)
            range.change { scaled(factor, xAt(event.clientX.toDouble())) }
        } else {
            range.change { shifted(event.deltaX * lines / over.clientWidth * visible.width) }
        }
    }

    private companion object {
        const val TOUCH = "touch"
        const val FEWEST_PIXELS = 4.0
        const val DOUBLE_TAP_MILLISECONDS = 350.0
        const val DOUBLE_TAP_PIXELS = 24.0
        const val WHEEL_PAUSE_MILLISECONDS = 500.0
        const val PIXELS_OF_LINE = 16.0
        const val WHEEL_SPEED = 0.008
    }
}
