package badlog.viewer.session.gesture

import badlog.viewer.input.DragKind
import badlog.viewer.input.OverviewGrip
import badlog.viewer.input.PlotPointer
import badlog.viewer.state.PlaceAction

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
