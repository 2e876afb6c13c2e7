package badlog.viewer.graph.scene

import androidx.compose.ui.geometry.Offset
import badlog.analysis.Span
import badlog.plot.cursor.Cursors
import badlog.plot.gesture.DragKind
import badlog.plot.gesture.Wheel
import badlog.viewer.board.GraphBoard
import badlog.viewer.playback.Player
import badlog.viewer.view.AxisView
import badlog.viewer.view.PlotGesture

/** What the pointer does over the graphs, in places on the axes rather than pixels. */
internal class PlotGestures(private val view: AxisView, private val board: GraphBoard, private val player: Player) {
    private val wheel = Wheel()

    private var beforeClick = Cursors()

    /** The pointer passes over [x]: the cursor goes along unless it is pinned, or runs by itself. */
    fun hover(x: Double) {
        if (view.isCursorPinned || !player.state.isPlaying) view.changeCursors { hovering(x.within(view.viewport.full)) }
    }

    /** The pointer leaves the graphs. */
    fun leave() = view.changeCursors { left() }

    /** A click at [x]; [reach] is how far beside a cursor it is still on it. */
    fun click(x: Double, reach: Double, shift: Boolean) {
        val place = x.within(view.viewport.full)
        beforeClick = view.cursors
        view.changeCursors { if (shift) shiftClicked(place, reach) else clicked(place, reach) }
    }

    /** A double click shows everything, of graph [id] all of y too. */
    fun doubleClick(id: Int?) {
        // The first of the two was no click of its own.
        view.changeCursors { beforeClick }
        view.change { reset() }
        if (id != null) board.change { withYRange(id, null) }
    }

    /** A drag begins at [x] and [y] of graph [id]. */
    fun begin(kind: DragKind, id: Int?, x: Double, y: Double) {
        view.drag(PlotGesture(kind, id, x, y, view.viewport))
        if (kind == DragKind.PAN) view.change { remembered() }
    }

    /** It goes on to [x] and [y]. */
    fun drag(x: Double, y: Double) {
        val gesture = view.gesture ?: return
        if (gesture.kind == DragKind.PAN) {
            // What was touched stays below the pointer.
            view.change { shifted(gesture.startX - x) }
        } else {
            view.drag(gesture.copy(x = x.within(view.viewport.visible), y = y))
            hover(x)
        }
    }

    /** It ends. */
    fun end() {
        val gesture = view.gesture ?: return
        view.drag(null)
        when (gesture.kind) {
            DragKind.ZOOM -> if (gesture.xSpan.width > 0) view.change { showing(gesture.startX, gesture.x) }

            DragKind.ZOOM_Y -> if (gesture.graph != null && gesture.ySpan.width > 0) {
                board.change { withYRange(gesture.graph, gesture.ySpan) }
            }

            DragKind.SELECT -> view.select(gesture.xSpan.takeIf { it.width > 0 })

            DragKind.PAN -> Unit
        }
    }

    /**
     * The wheel turns by [notches], or two fingers move over a touch pad, over [x] of a plot [width] dp wide; [millis] is the time of
     * any clock. False where that is not for the graphs, but scrolls them.
     */
    fun wheel(notches: Offset, ctrl: Boolean, shift: Boolean, x: Double, width: Float, millis: Long): Boolean {
        val (right, down) = notches * Wheel.NOTCH.toFloat()
        val turned = wheel.turned(
            view.viewport,
            right.toDouble(),
            down.toDouble(),
            ctrl,
            shift,
            x,
            width.toDouble(),
            millis.toDouble(),
        )
        turned?.let { view.change { it } }
        return turned != null
    }

    private fun Double.within(span: Span) = coerceIn(span.from, span.to)
}
