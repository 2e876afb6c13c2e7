package badlog.window.graph.scene

import androidx.compose.ui.geometry.Offset
import badlog.core.analysis.Span
import badlog.viewer.input.DragKind
import badlog.viewer.input.Wheel
import badlog.viewer.shown.cursor.Cursors
import badlog.window.log.AxisView
import badlog.window.log.GraphBoard
import badlog.window.log.PlotGesture
import badlog.window.video.Player

/** What the pointer does over the graphs, in places on the axes rather than pixels. */
internal class PlotGestures(private val view: AxisView, private val board: GraphBoard, private val player: Player) {
    private val wheel = Wheel()

    private var beforeClick = Cursors()

    /** Handles the pointer at [x]: the cursor follows unless it is pinned, or moved by playback. */
    fun hover(x: Double) {
        if (view.isCursorPinned || !player.state.isPlaying) view.changeCursors { hovering(x.within(view.viewport.full)) }
    }

    /** Handles the pointer leaving the graphs. */
    fun leave() = view.changeCursors { left() }

    /** Handles a click at [x]; [reach] is the maximum distance at which it is still on a cursor. */
    fun click(x: Double, reach: Double, shift: Boolean) {
        val place = x.within(view.viewport.full)
        beforeClick = view.cursors
        view.changeCursors { if (shift) shiftClicked(place, reach) else clicked(place, reach) }
    }

    /** Handles a double click: shows everything, including all of y in graph [id]. */
    fun doubleClick(id: Int?) {
        // The first click of a double click does not count by itself.
        view.changeCursors { beforeClick }
        view.change { reset() }
        if (id != null) board.change { withYRange(id, null) }
    }

    /** Begins a drag at [x] and [y] of graph [id]. */
    fun begin(kind: DragKind, id: Int?, x: Double, y: Double) {
        view.drag(PlotGesture(kind, id, x, y, view.viewport))
        if (kind == DragKind.PAN) view.change { remembered() }
    }

    /** Moves the drag to [x] and [y]. */
    fun drag(x: Double, y: Double) {
        val gesture = view.gesture ?: return
        if (gesture.kind == DragKind.PAN) {
            // What was touched stays under the pointer.
            view.change { shifted(gesture.startX - x) }
        } else {
            view.drag(gesture.copy(x = x.within(view.viewport.visible), y = y))
            hover(x)
        }
    }

    /** Ends the drag. */
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
     * Handles a turn of the wheel by [notches], or two fingers on a touch pad, over [x] of a plot [width] dp wide; [millis] is the
     * time of any clock. Returns false if it should scroll instead.
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
