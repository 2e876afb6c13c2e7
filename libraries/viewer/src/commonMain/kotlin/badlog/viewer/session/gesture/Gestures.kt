package badlog.viewer.session.gesture

import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.path.XyPicture
import badlog.viewer.input.DoubleClick
import badlog.viewer.input.DragKind
import badlog.viewer.input.PlotPointer
import badlog.viewer.input.PointerButton
import badlog.viewer.input.Wheel
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.Action
import badlog.viewer.state.Place
import badlog.viewer.state.PlaceAction
import kotlin.math.hypot

/** The state that gestures change, on the page and in the window. */
interface GestureTarget {
    /** The person's place in the log. */
    val place: Place

    /** Whether something else, such as playback, moves the cursor while it is not pinned. */
    val isCursorLed: Boolean get() = false

    /** Sends [action], which changes the state. */
    fun send(action: Action)
}

/**
 * Recognizes the gestures of a mouse or of fingers over a plot: clicks, double clicks, drags, pinches, long presses. A front end only
 * reports its events.
 */
abstract class Gestures internal constructor(private val target: GestureTarget) {
    private val clicks = DoubleClick()
    private val fingers = LinkedHashMap<Int, PlotPointer>()
    private var pressed: PlotPointer? = null
    private var kind = DragKind.ZOOM
    private var isDragging = false

    // A movement in a direction that does not count is neither a drag nor a click.
    private var hasMoved = false
    private var isPinching = false
    private var beforeClick = Cursors()

    /** Whether a pressed pointer has an effect: it receives all further moves, and Escape cancels its effect. */
    val isActive: Boolean get() = pressed != null || isPinching

    /** Handles a button or a finger that is pressed. */
    fun press(at: PlotPointer) {
        at.finger?.let { fingers[it] = at }
        if (fingers.size > 1) {
            stop(isGivenUp = false)
            if (!isPinching) beginPinch()
            isPinching = true
        } else if (pressed == null && !isPinching) {
            pressed = at
            hasMoved = false
            kind = kindOf(at)
        }
    }

    /** Handles a pointer that moves, pressed or not. */
    fun move(at: PlotPointer) {
        if (isPinching) return pinchTo(at)
        val start = pressed
        if (start == null) {
            if (at.finger == null) hover(at)
            return
        }
        if (at.finger != start.finger) return
        at.finger?.let { fingers[it] = at }
        if (hypot(at.x - start.x, at.y - start.y) >= DragKind.MIN_DISTANCE) hasMoved = true
        if (!isDragging) {
            if (lengthOf(kind, start, at) < DragKind.MIN_DISTANCE) return
            isDragging = true
            begin(kind, start)
        }
        drag(at)
    }

    /** Handles a button or a finger that is released. */
    fun release(at: PlotPointer) {
        if (lift(at)) return
        val start = pressed?.takeIf { it.finger == at.finger } ?: return
        if (isDragging) {
            drag(at)
            end()
        } else if (kind != DragKind.SELECT && (!hasMoved || start.finger != null)) {
            click(at, start.shift)
        }
        stop(isGivenUp = false)
    }

    /** Handles a pointer that sends no further events here, such as a finger that scrolls. */
    fun cancel(at: PlotPointer) {
        lift(at)
        if (pressed?.finger == at.finger) stop(isGivenUp = false)
    }

    /** Handles a finger that was down for [REST_MILLISECONDS]: if it has not moved, it is a click with Shift. */
    fun rest() {
        val start = pressed?.takeIf { it.finger != null && !isDragging } ?: return
        click(start, isShifted = true)
        stop(isGivenUp = false)
    }

    /** Handles a pointer that leaves the plot. */
    fun leave() {
        if (!isActive) target.send(PlaceAction.Leave)
    }

    /** Cancels a drag, and undoes its changes. */
    fun giveUp() = stop(isGivenUp = true)

    /**
     * Handles a turn of the wheel, or of two fingers on a touch pad. The turn is [right] and [down] in CSS pixels or dp. Returns false if
     * it scrolls instead.
     */
    abstract fun wheel(at: PlotPointer, right: Double, down: Double): Boolean

    /** Returns the effect of a drag that begins at [at]. */
    internal abstract fun kindOf(at: PlotPointer): DragKind

    /** Returns the x under the pointer; null if there is none. */
    abstract fun placeAt(at: PlotPointer): Double?

    /** Begins a drag at [start], where the pointer was pressed. */
    internal abstract fun begin(kind: DragKind, start: PlotPointer)

    /** Moves the drag to [at]. */
    internal abstract fun drag(at: PlotPointer)

    /** Applies the drag. */
    internal abstract fun end()

    /** Ends the drag, and undoes its changes if it [isGivenUp]. */
    internal abstract fun forget(isGivenUp: Boolean)

    /** Shows everything, after a double click. */
    internal abstract fun reset()

    /** Handles the start of a pinch. */
    internal open fun beginPinch() = Unit

    /** Scales the visible part by [factor], while the finger [other] stays at its place. A factor above 1 zooms out. */
    internal open fun pinch(other: PlotPointer, factor: Double) = Unit

    /** Returns the distance between two fingers, in CSS pixels or dp. */
    internal open fun distance(one: PlotPointer, other: PlotPointer): Double = hypot(one.x - other.x, one.y - other.y)

    /** Returns the length of a drag from [start] to [at], in the direction that counts for its [kind]. */
    internal open fun lengthOf(kind: DragKind, start: PlotPointer, at: PlotPointer): Double = distance(start, at)

    /** Handles a pointer that moves without being pressed. */
    internal open fun hover(at: PlotPointer) {
        placeAt(at)?.let(::hoverAt)
    }

    /** Handles a click that is not the second of a double click. */
    internal open fun clickAt(at: PlotPointer, isShifted: Boolean) {
        placeAt(at)?.let { target.send(PlaceAction.Click(it, reachOf(at), isShifted)) }
    }

    /** Returns the maximum distance on x at which a click at [at] is still on a cursor. */
    internal open fun reachOf(at: PlotPointer): Double = 0.0

    /** Moves the cursor to [x], unless something else moves it. */
    internal fun hoverAt(x: Double) {
        if (target.place.cursors.isPinned || !target.isCursorLed) target.send(PlaceAction.Hover(x))
    }

    private fun click(at: PlotPointer, isShifted: Boolean) {
        if (isShifted) return clickAt(at, true)
        if (clicks.isSecond(at.x, at.millis)) {
            // The first click of a double click has no effect of its own.
            target.send(PlaceAction.Point(beforeClick))
            return reset()
        }
        beforeClick = target.place.cursors
        clickAt(at, false)
    }

    /** Returns true until all fingers of a pinch are lifted, so that lifting them is not a click. */
    private fun lift(at: PlotPointer): Boolean {
        at.finger?.let(fingers::remove)
        val wasPinching = isPinching
        if (fingers.isEmpty()) isPinching = false
        return wasPinching
    }

    private fun pinchTo(at: PlotPointer) {
        val before = fingers[at.finger ?: return] ?: return
        fingers[at.finger] = at
        val other = fingers.values.firstOrNull { it.finger != at.finger } ?: return
        val (old, new) = distance(before, other) to distance(at, other)
        if (old > MIN_DISTANCE && new > MIN_DISTANCE) pinch(other, old / new)
    }

    private fun stop(isGivenUp: Boolean) {
        if (isDragging) forget(isGivenUp)
        pressed = null
        isDragging = false
    }

    companion object {
        /** The duration of a long press, in ms. */
        const val REST_MILLISECONDS: Int = 500

        /** The minimum distance of two fingers in CSS pixels or dp; closer ones count as one. */
        private const val MIN_DISTANCE = 10.0
    }
}

/**
 * A drag over a graph of y over x.
 *
 * @property seen the visible part at its start.
 * @property before the selected part at its start; null for the whole plane.
 */
data class XyDrag(val kind: DragKind, val start: PlotPointer, val seen: Plane, val before: Plane?, val at: PlotPointer = start)

/** The state that gestures over a graph of y over x change. */
interface XyTarget : GestureTarget {
    /** The picture in the graph. */
    val picture: XyPicture

    /** The part of the plane that a person has selected; null for the whole plane. */
    var plane: Plane?

    /** The current drag, for display; null if there is none. */
    var drag: XyDrag?

    /** Returns the visible part of the plane in a frame of [width] by [height]; null if nothing is visible. */
    fun seen(width: Double, height: Double): Plane? = picture.seen(plane, width, height)
}

/**
 * The gestures of a mouse or of fingers over a graph of y over x. They move the cursor to the time when the path passes them, and zoom and
 * pan as over other graphs.
 */
class XyGestures(private val target: XyTarget) : Gestures(target) {
    override fun kindOf(at: PlotPointer): DragKind {
        // A finger moves the plane, as on a map; a mouse draws a selection frame.
        val isPan = at.finger != null || at.shift || at.button == PointerButton.MIDDLE
        return if (isPan) DragKind.PAN else DragKind.ZOOM
    }

    override fun begin(kind: DragKind, start: PlotPointer) {
        target.drag = XyDrag(kind, start, seen(start) ?: return, target.plane)
    }

    override fun drag(at: PlotPointer) {
        val drag = target.drag?.copy(at = at) ?: return
        target.drag = drag
        val start = drag.start
        if (drag.kind != DragKind.PAN) return
        show(drag.seen.shifted((start.shareX - at.shareX) * drag.seen.x.width, (at.shareY - start.shareY) * drag.seen.y.width))
    }

    override fun end() {
        val drag = target.drag ?: return
        if (drag.kind != DragKind.ZOOM) return
        show(drag.seen.part(drag.start.shareX, drag.start.shareY, drag.at.shareX, drag.at.shareY))
    }

    override fun forget(isGivenUp: Boolean) {
        val drag = target.drag ?: return
        target.drag = null
        if (isGivenUp && drag.kind == DragKind.PAN) target.plane = drag.before
    }

    override fun reset() {
        target.plane = null
    }

    override fun pinch(other: PlotPointer, factor: Double) = scale(other, factor)

    override fun wheel(at: PlotPointer, right: Double, down: Double): Boolean {
        if (at.ctrl) scale(at, Wheel.factorOf(down))
        return at.ctrl
    }

    private fun scale(at: PlotPointer, factor: Double) {
        val plane = seen(at) ?: return
        show(plane.scaled(factor, plane.xAt(at.shareX), plane.yAt(at.shareY)))
    }

    private fun show(plane: Plane) {
        if (plane.isDrawable) target.plane = plane
    }

    private fun seen(at: PlotPointer) = target.seen(at.width, at.height)

    /** Returns the time when the path passed the place of [at]; null if the path is not near. */
    override fun placeAt(at: PlotPointer): Double? {
        val plane = seen(at) ?: return null
        return target.picture.timeAt(
            x = plane.xAt(at.shareX),
            y = plane.yAt(at.shareY),
            pixelX = plane.x.width / at.width,
            pixelY = plane.y.width / at.height,
            reach = REACH,
            visible = target.place.range.visible,
            before = target.place.cursors.x,
        )
    }
}

/** The maximum distance between the path and a pointer that selects it, in CSS pixels or dp. */
private const val REACH = 60.0
