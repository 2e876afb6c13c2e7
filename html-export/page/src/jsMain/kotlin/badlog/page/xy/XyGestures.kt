package badlog.page.xy

import badlog.page.dom.EscapeKey
import badlog.page.view.Scene
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.path.XyPlot
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.input.DoubleClick
import badlog.viewer.input.DragKind
import badlog.viewer.input.Wheel
import org.w3c.dom.events.Event
import org.w3c.dom.events.WheelEvent
import org.w3c.dom.pointerevents.PointerEvent
import kotlin.math.abs
import kotlin.math.hypot

/**
 * Makes the pointer place the cursor where the path passes it, zoom and pan, as over other graphs.
 *
 * @param seen returns what is visible now.
 * @param onShow called with the part that a person wants to see; null for all of it.
 */
internal class XyGestures(
    private val over: XyCanvas,
    private val scene: Scene,
    private val plot: XyPlot,
    private val seen: (PlotFrame) -> Plane,
    private val onShow: (Plane?) -> Unit,
) {
    private val clicks = DoubleClick()
    private val escape = EscapeKey(::giveUp)
    private val fingers = LinkedHashMap<Int, PointerEvent>()
    private var pressed: PointerEvent? = null
    private var before: Plane? = null
    private var hasMoved = false

    init {
        on("pointerdown") { press(it.unsafeCast<PointerEvent>()) }
        on("pointermove") { move(it.unsafeCast<PointerEvent>()) }
        on("pointerup") { release(it.unsafeCast<PointerEvent>()) }
        on("pointercancel") {
            fingers.remove(it.unsafeCast<PointerEvent>().pointerId)
            stop()
        }
        on("pointerleave") { if (pressed == null) scene.cursor.change { left() } }
        on("wheel") { wheel(it.unsafeCast<WheelEvent>()) }
    }

    private fun on(type: String, listener: (Event) -> Unit) = over.canvas.addEventListener(type, listener)

    private fun press(event: PointerEvent) {
        if (event.button.toInt() != 0) return
        over.canvas.setPointerCapture(event.pointerId)
        if (isTouch(event)) fingers[event.pointerId] = event
        if (fingers.size > 1) return stop()
        pressed = event
        before = seen(over.frame)
        hasMoved = false
        escape.take()
    }

    private fun move(event: PointerEvent) {
        val start = pressed
        if (start == null) {
            if (isTouch(event)) pinch(event) else timeAt(event)?.let { scene.cursor.change { hovering(it) } }
            return
        }
        if (!hasMoved && abs(event.clientX - start.clientX) + abs(event.clientY - start.clientY) < DragKind.MIN_DISTANCE) return
        hasMoved = true
        val plane = before ?: return
        if (isPan(start)) {
            onShow(plane.shifted((x(start) - x(event)) * plane.x.width, (y(event) - y(start)) * plane.y.width))
        } else {
            val (width, height) = over.frame.width to over.frame.height
            over.draw { pen ->
                val accent = faded(scene.palette.colors[Shade.ACCENT], COVER)
                pen.rectangle(x(start) * width, y(start) * height, (x(event) - x(start)) * width, (y(event) - y(start)) * height, accent)
            }
        }
    }

    /** What was between two fingers stays between them. */
    private fun pinch(event: PointerEvent) {
        val last = fingers[event.pointerId] ?: return
        val other = fingers.values.firstOrNull { it.pointerId != event.pointerId } ?: return
        fingers[event.pointerId] = event
        val factor = distance(last, other) / distance(event, other)
        val plane = seen(over.frame)
        if (factor.isFinite() && factor > 0) onShow(plane.scaled(factor, plane.xAt(x(other)), plane.yAt(y(other))))
    }

    private fun distance(one: PointerEvent, other: PointerEvent) =
        hypot((one.clientX - other.clientX).toDouble(), (one.clientY - other.clientY).toDouble())

    private fun giveUp() {
        if (hasMoved) onShow(before)
        stop()
    }

    private fun stop() {
        escape.giveBack()
        pressed = null
    }

    private fun release(event: PointerEvent) {
        fingers.remove(event.pointerId)
        val start = pressed ?: return
        stop()
        if (!hasMoved) {
            tap(event)
        } else if (!isPan(start)) {
            onShow(before?.part(x(start), y(start), x(event), y(event)))
        }
    }

    private fun tap(event: PointerEvent) {
        if (clicks.isSecond(event.clientX.toDouble(), event.timeStamp.toDouble())) return onShow(null)
        timeAt(event)?.let { time -> scene.cursor.change { if (event.shiftKey) shiftClicked(time, 0.0) else clicked(time, 0.0) } }
    }

    private fun wheel(event: WheelEvent) {
        if (!event.ctrlKey && event.asDynamic().metaKey != true) return
        event.preventDefault()
        val down = event.deltaY * if (event.deltaMode == WheelEvent.DOM_DELTA_LINE) LINE else 1.0
        val plane = seen(over.frame)
        val atX = plane.xAt(over.shareX(event.clientX.toDouble()))
        onShow(plane.scaled(Wheel.factorOf(down), atX, plane.yAt(over.shareY(event.clientY.toDouble()))))
    }

    // A finger moves what it touches, as on a map; a mouse draws a selection frame.
    private fun isPan(start: PointerEvent) = start.shiftKey || isTouch(start)

    private fun isTouch(event: PointerEvent) = event.pointerType == "touch"

    private fun x(event: PointerEvent) = over.shareX(event.clientX.toDouble())

    private fun y(event: PointerEvent) = over.shareY(event.clientY.toDouble())

    /** Returns when the path passed the place of [event]; null if it is not near. */
    private fun timeAt(event: PointerEvent): Double? {
        val plane = seen(over.frame)
        val time = plot.timeAt(
            x = plane.xAt(x(event)),
            y = plane.yAt(y(event)),
            pixelX = plane.x.width / over.frame.width,
            pixelY = plane.y.width / over.frame.height,
            reach = REACH * pixelRatio,
            visible = scene.range.now,
            before = scene.cursor.now.x,
        )
        return time.takeUnless { it.isNaN() }
    }

    private companion object {
        /** The maximum distance from the path at which the pointer still selects it, in CSS pixels. */
        const val REACH = 60
        const val LINE = 16.0
        const val COVER = 0.25
    }
}
