package badlog.page.input

import badlog.page.dom.EscapeKey
import badlog.viewer.input.PlotPointer
import badlog.viewer.session.gesture.Gestures
import kotlinx.browser.window
import org.w3c.dom.DOMRect
import org.w3c.dom.HTMLElement
import org.w3c.dom.events.Event
import org.w3c.dom.events.MouseEvent
import org.w3c.dom.events.WheelEvent
import org.w3c.dom.pointerevents.PointerEvent

/**
 * Passes gestures of a mouse or of fingers over an element to [gestures]. The browser handles vertical swipes, which scroll the page.
 *
 * @param frame returns the position in the window of the frame under the gestures.
 * @param onHover called with the position of a pointer that is not pressed.
 */
internal class PointerListener(
    private val over: HTMLElement,
    private val gestures: Gestures,
    private val frame: () -> DOMRect = { over.getBoundingClientRect() },
    private val onHover: (PlotPointer) -> Unit = {},
) {
    private val escape = EscapeKey {
        gestures.giveUp()
        update()
    }
    private var resting = 0

    init {
        on("pointerdown") { press(it.unsafeCast<PointerEvent>()) }
        on("pointermove") { move(pointerOf(it.unsafeCast<PointerEvent>())) }
        on("pointerup") {
            gestures.release(pointerOf(it.unsafeCast<PointerEvent>()))
            update()
        }
        on("pointercancel") {
            gestures.cancel(pointerOf(it.unsafeCast<PointerEvent>()))
            update()
        }
        on("pointerleave") { gestures.leave() }
        // Otherwise a long press opens the browser's menu.
        on("contextmenu") { if (it.asDynamic().pointerType == TOUCH) it.preventDefault() }
        on("wheel") { wheel(it.unsafeCast<WheelEvent>()) }
    }

    private fun on(type: String, listener: (Event) -> Unit) = over.addEventListener(type, listener)

    private fun press(event: PointerEvent) {
        if (event.button.toInt() != 0) return
        over.setPointerCapture(event.pointerId)
        gestures.press(pointerOf(event))
        update()
        if (event.pointerType != TOUCH) return
        resting = window.setTimeout({
            gestures.rest()
            update()
        }, Gestures.REST_MILLISECONDS)
    }

    private fun move(at: PlotPointer) {
        gestures.move(at)
        if (!gestures.isActive) onHover(at)
    }

    private fun update() {
        window.clearTimeout(resting)
        if (gestures.isActive) escape.take() else escape.giveBack()
    }

    private fun pointerOf(event: PointerEvent): PlotPointer =
        pointerAt(event, finger = event.pointerId.takeIf { event.pointerType == TOUCH }, ctrl = false)

    private fun wheel(event: WheelEvent) {
        val pixels = if (event.deltaMode == WheelEvent.DOM_DELTA_LINE) PIXELS_OF_LINE else 1.0
        val at = pointerAt(event, finger = null, ctrl = event.ctrlKey || event.metaKey)
        if (gestures.wheel(at, event.deltaX * pixels, event.deltaY * pixels)) event.preventDefault()
    }

    private fun pointerAt(event: MouseEvent, finger: Int?, ctrl: Boolean): PlotPointer {
        val box = frame()
        return PlotPointer(
            event.clientX - box.left,
            event.clientY - box.top,
            box.width,
            box.height,
            // The time of the event itself, because a busy page may handle it later.
            event.timeStamp.toDouble(),
            event.shiftKey,
            event.altKey,
            ctrl,
            finger = finger,
        )
    }
}

private const val TOUCH = "touch"
private const val PIXELS_OF_LINE = 16.0
