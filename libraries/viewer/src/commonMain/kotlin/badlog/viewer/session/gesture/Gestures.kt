package badlog.viewer.session.gesture

import badlog.viewer.input.DoubleClick
import badlog.viewer.input.DragKind
import badlog.viewer.input.PlotPointer
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.Action
import badlog.viewer.state.Place
import badlog.viewer.state.PlaceAction
import kotlin.math.hypot

/** What gestures change, on the page and in the window. */
interface GestureTarget {
    /** Where the person is in the log. */
    val place: Place

    /** Whether something else moves the cursor that is not pinned, such as playback. */
    val isCursorLed: Boolean get() = false

    /** Lets [action] change the state. */
    fun send(action: Action)
}

/**
 * Recognizes what a person does with a mouse or fingers over a plot: clicks, double clicks, drags, pinches, long presses. A front end
 * only reports its events.
 */
abstract class Gestures internal constructor(private val target: GestureTarget) {
    private val clicks = DoubleClick()
    private val fingers = LinkedHashMap<Int, PlotPointer>()
    private var pressed: PlotPointer? = null
    private var kind = DragKind.ZOOM
    private var isDragging = false

    // A drag in a direction that does not count is neither a drag nor a click.
    private var hasMoved = false
    private var isPinching = false
    private var beforeClick = Cursors()

    /** Whether a pointer is down that means something: further moves are its, and Escape cancels what it does. */
    val isActive: Boolean get() = pressed != null || isPinching

    /** Handles a button or a finger that comes down. */
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

    /** Handles a button or a finger that goes up. */
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

    /** Handles a pointer whose events go elsewhere from now on, such as a finger that scrolls. */
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

    /** Cancels a drag: what it has changed is as before. */
    fun giveUp() = stop(isGivenUp = true)

    /**
     * Handles a turn of the wheel, or of two fingers on a touch pad, by [right] and [down] in CSS pixels or dp. Returns false if it scrolls
     * instead.
     */
    abstract fun wheel(at: PlotPointer, right: Double, down: Double): Boolean

    /** Returns what a drag does that begins at [at]. */
    internal abstract fun kindOf(at: PlotPointer): DragKind

    /** Returns the place on x that the pointer is on; null for none. */
    abstract fun placeAt(at: PlotPointer): Double?

    /** Begins a drag where it was pressed: at [start]. */
    internal abstract fun begin(kind: DragKind, start: PlotPointer)

    /** Moves the drag to [at]. */
    internal abstract fun drag(at: PlotPointer)

    /** Does what the drag was for. */
    internal abstract fun end()

    /** Forgets the drag; undoes what it has changed if it [isGivenUp]. */
    internal abstract fun forget(isGivenUp: Boolean)

    /** Shows everything, after a double click. */
    internal abstract fun reset()

    /** Handles the start of a pinch. */
    internal open fun beginPinch() = Unit

    /** Makes what is shown [factor] times as large, while the finger [other] stays on what it is on. */
    internal open fun pinch(other: PlotPointer, factor: Double) = Unit

    /** Returns how far apart two fingers are, in CSS pixels or dp. */
    internal open fun distance(one: PlotPointer, other: PlotPointer): Double = hypot(one.x - other.x, one.y - other.y)

    /** Returns how far a pointer has moved, in the direction that counts for a drag of this [kind]. */
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
            // The first click of a double click does not count by itself.
            target.send(PlaceAction.Point(beforeClick))
            return reset()
        }
        beforeClick = target.place.cursors
        clickAt(at, false)
    }

    /** Returns true until a pinch is over, so that lifting its fingers is not a click. */
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
        /** How long a finger rests for a long press, in ms. */
        const val REST_MILLISECONDS: Int = 500

        /** Fingers closer than this many CSS pixels or dp count as one. */
        private const val MIN_DISTANCE = 10.0
    }
}
