package badlog.page.graph

import badlog.page.dom.EscapeKey
import badlog.page.dom.add
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.viewer.input.DoubleClick
import badlog.viewer.input.DragKind
import badlog.viewer.input.Wheel
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.text.lengthText
import kotlinx.browser.window
import org.w3c.dom.HTMLElement
import org.w3c.dom.events.Event
import org.w3c.dom.events.WheelEvent
import org.w3c.dom.pointerevents.PointerEvent
import kotlin.math.abs

/**
 * What a mouse or fingers do over a plot: the gestures of [DragKind], [Wheel] and [Cursors]. Fingers pin the cursor, drag, and pinch. A
 * long press is a click with Shift; a vertical swipe is left to the browser, and scrolls the page.
 *
 * @param onZoomY called with the part of the plot's height that is to fill it, as fractions from its top; null if y means nothing.
 * @param onReset called when everything is to be shown.
 */
internal class PlotGestures(
    private val over: HTMLElement,
    private val scene: Scene,
    private val onZoomY: ((from: Double, to: Double) -> Unit)?,
    private val onReset: () -> Unit,
) {
    private val selection = over.add("div", "selection").apply { isHidden = true }
    private val range = scene.range
    private val pinch = Pinch(range, ::xAt)
    private val escape = EscapeKey(::giveUp)
    private val wheel = Wheel()
    private val taps = DoubleClick()
    private var drag: DragKind? = null
    private var startSpan = range.now
    private var startX = 0.0
    private var startY = 0.0
    private var lastX = 0.0
    private var hasMoved = false
    private var isShifted = false
    private var isFinger = false
    private var beforeTap = scene.cursor.now
    private var resting = 0

    init {
        on("pointerdown") { press(it.unsafeCast<PointerEvent>()) }
        on("pointermove") { move(it.unsafeCast<PointerEvent>()) }
        on("pointerup") { release(it.unsafeCast<PointerEvent>()) }
        on("pointerleave") { if (drag == null) scene.cursor.change { left() } }
        on("pointercancel") { cancel(it.unsafeCast<PointerEvent>()) }
        // Otherwise a long press opens the browser's menu.
        on("contextmenu") { if (it.asDynamic().pointerType == TOUCH) it.preventDefault() }
        on("wheel") { wheel(it.unsafeCast<WheelEvent>()) }
    }

    private fun on(type: String, listener: (Event) -> Unit) = over.addEventListener(type, listener)

    /** Returns the x at the pixel [clientX], extrapolated beyond the frame. */
    private fun xAt(clientX: Double): Double {
        val box = over.getBoundingClientRect()
        return range.now.from + (clientX - box.left) / box.width * range.now.width
    }

    /** Returns the same, limited to the frame: a drag ends at its edge. */
    private fun xWithin(clientX: Double): Double = xAt(clientX).coerceIn(range.now.from, range.now.to)

    private fun press(event: PointerEvent) {
        if (event.button.toInt() != 0) return
        over.setPointerCapture(event.pointerId)
        if (event.pointerType == TOUCH && pinch.press(event)) {
            stop()
            return
        }
        // A finger moves what it touches, as on a map; a mouse draws a selection frame.
        val kind = if (event.pointerType == TOUCH) DragKind.of(range.isZoomed, alt = false) else DragKind.of(event.shiftKey, event.altKey)
        drag = if (kind == DragKind.ZOOM_Y && onZoomY == null) DragKind.ZOOM else kind
        startX = event.clientX.toDouble()
        startY = event.clientY.toDouble()
        startSpan = range.now
        lastX = startX
        hasMoved = false
        isShifted = event.shiftKey
        isFinger = event.pointerType == TOUCH
        escape.take()
        if (isFinger) resting = window.setTimeout({ rest() }, REST_MILLISECONDS)
    }

    /** Handles a long press: the finger has not moved for a while. */
    private fun rest() {
        if (drag == null || hasMoved) return
        isShifted = true
        tap(startX, Double.NaN)
        stop()
    }

    private fun move(event: PointerEvent) {
        val x = event.clientX.toDouble()
        if (pinch.move(event)) return
        val kind = drag
        if (kind == null) {
            if (event.pointerType != TOUCH) scene.cursor.change { hovering(xAt(x)) }
            return
        }
        val y = event.clientY.toDouble()
        if (!hasMoved && abs(if (kind == DragKind.ZOOM_Y) y - startY else x - startX) < DragKind.MIN_DISTANCE) return
        if (!hasMoved && kind == DragKind.PAN) range.change { remembered() }
        hasMoved = true
        when (kind) {
            DragKind.PAN -> pan(x)
            DragKind.ZOOM_Y -> selectY(y)
            else -> select(x)
        }
    }

    private fun pan(x: Double) {
        val distance = xAt(lastX) - xAt(x)
        lastX = x
        range.change { shifted(distance) }
    }

    private fun select(x: Double) {
        val place = xWithin(x)
        val box = over.getBoundingClientRect()
        val from = (minOf(startX, x) - box.left).coerceIn(0.0, box.width)
        val to = (maxOf(startX, x) - box.left).coerceIn(0.0, box.width)
        selection.isHidden = false
        selection.style.height = ""
        selection.style.transform = "translateX(${from}px)"
        selection.style.width = "${to - from}px"
        selection.showText("Δ " + lengthText((to - from) / box.width * range.now.width, scene.xAxis))
        scene.cursor.change { hovering(place) }
    }

    private fun selectY(y: Double) {
        val height = over.clientHeight
        val top = yWithin(minOf(startY, y))
        selection.isHidden = false
        selection.showText("")
        selection.style.transform = "translateY(${top * height}px)"
        selection.style.width = "100%"
        selection.style.height = "${(yWithin(maxOf(startY, y)) - top) * height}px"
    }

    /** Returns where the pixel [clientY] is, as a fraction of the plot's height from its top. */
    private fun yWithin(clientY: Double): Double {
        val box = over.getBoundingClientRect()
        return ((clientY - box.top) / box.height).coerceIn(0.0, 1.0)
    }

    private fun release(event: PointerEvent) {
        if (pinch.release(event)) return
        val x = event.clientX.toDouble()
        val y = event.clientY.toDouble()
        if (hasMoved && drag == DragKind.ZOOM) range.change { showing(xWithin(startX), xWithin(x)) }
        if (hasMoved && drag == DragKind.ZOOM_Y) onZoomY?.invoke(yWithin(minOf(startY, y)), yWithin(maxOf(startY, y)))
        if (drag != null && !hasMoved) tap(x, event.timeStamp.toDouble())
        stop()
    }

    /** Handles a click at [x] at the time [now], which is when it was made: a busy page may handle it later. */
    private fun tap(x: Double, now: Double) {
        val reach = (if (isFinger) Cursors.FINGER_REACH else Cursors.REACH) / over.clientWidth * range.now.width
        when {
            isShifted -> scene.cursor.change { shiftClicked(xAt(x), reach) }

            taps.isSecond(x, now) -> {
                // The first click of a double click does not count by itself.
                scene.cursor.change { beforeTap }
                range.change { reset() }
                onReset()
            }

            else -> {
                beforeTap = scene.cursor.now
                scene.cursor.change { clicked(xAt(x), reach) }
            }
        }
    }

    private fun cancel(event: PointerEvent) {
        pinch.release(event)
        stop()
    }

    private fun giveUp() {
        if (drag == DragKind.PAN) range.change { moved(startSpan.from, startSpan.to) }
        stop()
    }

    private fun stop() {
        window.clearTimeout(resting)
        escape.giveBack()
        drag = null
        selection.isHidden = true
    }

    private fun wheel(event: WheelEvent) {
        val ctrl = event.ctrlKey || event.asDynamic().metaKey == true
        val pixels = if (event.deltaMode == WheelEvent.DOM_DELTA_LINE) PIXELS_OF_LINE else 1.0
        val turned = wheel.turned(
            range.viewport,
            event.deltaX * pixels,
            event.deltaY * pixels,
            ctrl,
            event.shiftKey,
            xAt(event.clientX.toDouble()),
            over.clientWidth.toDouble(),
            event.timeStamp.toDouble(),
        ) ?: return
        event.preventDefault()
        range.change { turned }
    }

    private companion object {
        const val TOUCH = "touch"
        const val PIXELS_OF_LINE = 16.0
        const val REST_MILLISECONDS = 500
    }
}
