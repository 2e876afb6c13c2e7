package badlog.viewer.session.gesture

import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.path.XyPicture
import badlog.viewer.input.DragKind
import badlog.viewer.input.PlotPointer
import badlog.viewer.input.PointerButton
import badlog.viewer.input.Wheel

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

    private companion object {
        /** The maximum distance between the path and a pointer that selects it, in CSS pixels or dp. */
        const val REACH = 60.0
    }
}
