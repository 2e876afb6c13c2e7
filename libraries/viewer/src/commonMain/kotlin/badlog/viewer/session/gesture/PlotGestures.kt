package badlog.viewer.session.gesture

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import badlog.viewer.input.DragKind
import badlog.viewer.input.KeyAction
import badlog.viewer.input.OverviewGrip
import badlog.viewer.input.PlotPointer
import badlog.viewer.input.PointerButton
import badlog.viewer.input.Wheel
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.Action
import badlog.viewer.state.PlaceAction
import kotlin.math.abs

/** The state that gestures over a plot change. */
interface PlotTarget : GestureTarget {
    /** The current drag, for display; null if there is none, or if it was canceled here. */
    var drag: PlotDrag?

    /** The part of the plot’s height, from the top, that has lines; 0 if y has no meaning. */
    val lineShare: Double get() = 0.0

    /** Shows only [part] of y, as fractions of the visible height from the top; null shows all of y. */
    fun showY(part: Span?) = Unit
}

/** The gestures of a mouse or of fingers over a plot. If it [isAxis], they are over the axis below it, where a plain drag pans. */
open class PlotGestures(private val target: PlotTarget, private val isAxis: Boolean = false) : Gestures(target) {
    private val wheel = Wheel()
    private val visible get() = target.place.range.visible

    override fun kindOf(at: PlotPointer): DragKind = when {
        // A finger moves the plot, as on a map; a mouse draws a selection frame.
        at.finger != null -> if (isAxis || target.place.range.isZoomed) DragKind.PAN else DragKind.ZOOM

        at.button == PointerButton.MIDDLE -> DragKind.PAN

        at.button == PointerButton.RIGHT || at.ctrl -> DragKind.SELECT

        isAxis -> DragKind.PAN

        else -> DragKind.of(at.shift, at.alt && target.lineShare > 0)
    }

    override fun placeAt(at: PlotPointer): Double = visible.from + at.shareX * visible.width

    override fun reachOf(at: PlotPointer): Double =
        (if (at.finger == null) Cursors.REACH else Cursors.FINGER_REACH) / at.width * visible.width

    override fun distance(one: PlotPointer, other: PlotPointer): Double = abs(one.x - other.x)

    override fun lengthOf(kind: DragKind, start: PlotPointer, at: PlotPointer): Double =
        if (kind == DragKind.ZOOM_Y) abs(start.y - at.y) else distance(start, at)

    override fun begin(kind: DragKind, start: PlotPointer) {
        target.drag = PlotDrag(kind, placeAt(start), lineShareAt(start), target.place.range)
        if (kind == DragKind.PAN) target.send(PlaceAction.Remember)
    }

    override fun drag(at: PlotPointer) {
        val drag = target.drag ?: return
        val x = placeAt(at)
        // The touched place stays under the pointer.
        if (drag.kind == DragKind.PAN) return target.send(PlaceAction.Shift(drag.startX - x))
        val shown = x.coerceIn(visible.from, visible.to)
        target.drag = drag.copy(x = shown, y = lineShareAt(at))
        hoverAt(shown)
    }

    override fun end() {
        val drag = target.drag ?: return
        when (drag.kind) {
            DragKind.ZOOM -> if (drag.xSpan.width > 0) target.send(PlaceAction.Show(drag.startX, drag.x))
            DragKind.ZOOM_Y -> if (drag.ySpan.width > 0) target.showY(drag.ySpan)
            DragKind.SELECT -> target.send(PlaceAction.Select(drag.xSpan.takeIf { it.width > 0 }))
            DragKind.PAN -> Unit
        }
    }

    override fun forget(isGivenUp: Boolean) {
        val drag = target.drag ?: return
        target.drag = null
        if (isGivenUp) drag.undoing?.let(target::send)
    }

    override fun reset() {
        target.send(Action.Press(KeyAction.SHOW_ALL))
        target.showY(null)
    }

    override fun beginPinch() = target.send(PlaceAction.Remember)

    override fun pinch(other: PlotPointer, factor: Double) = target.send(PlaceAction.Scale(factor, placeAt(other)))

    override fun wheel(at: PlotPointer, right: Double, down: Double): Boolean {
        val turned = wheel.turned(target.place.range, right, down, at.ctrl, at.shift, placeAt(at), at.width, at.millis) ?: return false
        target.send(PlaceAction.Range(turned))
        return true
    }

    private fun lineShareAt(at: PlotPointer) = (at.shareY / target.lineShare).coerceIn(0.0, 1.0)
}

/**
 * A drag over a plot.
 *
 * @property startX the x of its start.
 * @property startY the distance of its start from the top of the lines, as a fraction of their height.
 * @property before the visible range at its start.
 * @property x the current x.
 * @property y the current fraction.
 */
data class PlotDrag(
    val kind: DragKind,
    val startX: Double,
    val startY: Double,
    val before: Viewport,
    val x: Double = startX,
    val y: Double = startY,
) {
    /** The dragged range of x. */
    val xSpan: Span get() = Span(minOf(startX, x), maxOf(startX, x))

    /** The dragged part of the lines' height, from the top. */
    val ySpan: Span get() = Span(minOf(startY, y), maxOf(startY, y))

    /** The action that undoes the drag's changes so far; null if there are none. */
    val undoing: PlaceAction? get() = if (kind == DragKind.PAN) PlaceAction.Range(before) else null
}

/**
 * The gestures of a mouse or of fingers over the overview, which always shows the whole log. Drags move the visible range or one of its
 * edges, or select a new one; a click moves the range there, and pins the cursor.
 */
class OverviewGestures(private val target: PlotTarget) : PlotGestures(target) {
    private var grip = OverviewGrip.NEW

    /** Returns the part of the overview that a drag from [at] grabs. */
    fun gripAt(at: PlotPointer): OverviewGrip = target.place.range.let { OverviewGrip.at(placeAt(at), it, it.full.width / at.width) }

    override fun placeAt(at: PlotPointer): Double =
        target.place.range.full.let { (it.from + at.shareX * it.width).coerceIn(it.from, it.to) }

    override fun kindOf(at: PlotPointer): DragKind = DragKind.PAN

    override fun begin(kind: DragKind, start: PlotPointer) {
        grip = gripAt(start)
        super.begin(kind, start)
    }

    override fun drag(at: PlotPointer) {
        val (_, start, _, before) = target.drag ?: return
        val x = placeAt(at)
        val seen = before.visible
        target.send(
            when (grip) {
                OverviewGrip.LEFT -> PlaceAction.Move(minOf(x, seen.to), seen.to)
                OverviewGrip.RIGHT -> PlaceAction.Move(seen.from, maxOf(x, seen.from))
                OverviewGrip.WINDOW -> PlaceAction.Move(seen.from + x - start, seen.to + x - start)
                OverviewGrip.NEW -> PlaceAction.Move(start, x)
            },
        )
    }

    override fun hover(at: PlotPointer) = Unit

    override fun clickAt(at: PlotPointer, isShifted: Boolean) = target.send(PlaceAction.Pick(placeAt(at)))
}
