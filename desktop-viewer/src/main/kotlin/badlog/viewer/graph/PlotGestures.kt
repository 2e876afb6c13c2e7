package badlog.viewer.graph

import androidx.compose.ui.geometry.Offset
import badlog.analysis.Span
import badlog.plot.gesture.DragKind
import badlog.plot.gesture.Wheel
import badlog.viewer.app.Viewer
import kotlin.math.abs

/** What the pointer does over the graphs, in places on the axes rather than pixels. */
internal class PlotGestures(private val viewer: Viewer) {
    private val wheel = Wheel()

    /** The pointer passes over [x]: the cursor goes along unless it is pinned, or runs by itself. */
    fun hover(x: Double) {
        if (!viewer.isCursorPinned && !viewer.playback.isPlaying) viewer.cursor = x.within(viewer.viewport.full)
    }

    /** A click at [x] pins the cursor there; one on the pinned cursor, at most [reach] beside it, lets it go. */
    fun click(x: Double, reach: Double) {
        val cursor = viewer.cursor
        val isOnCursor = viewer.isCursorPinned && cursor != null && abs(cursor - x) <= reach
        viewer.isCursorPinned = !isOnCursor
        viewer.cursor = x.within(viewer.viewport.full)
    }

    /** A double click shows everything, of graph [id] all of y too. */
    fun doubleClick(id: Int?) {
        viewer.isCursorPinned = false
        viewer.viewport = viewer.viewport.reset()
        if (id != null) viewer.graphs = viewer.graphs.withYRange(id, null)
    }

    /** A drag begins at [x] and [y] of graph [id]. */
    fun begin(kind: DragKind, id: Int?, x: Double, y: Double) {
        viewer.gesture = PlotGesture(kind, id, x, y, viewer.viewport)
        if (kind == DragKind.PAN) viewer.viewport = viewer.viewport.remembered()
    }

    /** It goes on to [x] and [y]. */
    fun drag(x: Double, y: Double) {
        val gesture = viewer.gesture ?: return
        if (gesture.kind == DragKind.PAN) {
            // What was touched stays below the pointer.
            viewer.viewport = viewer.viewport.shifted(gesture.startX - x)
        } else {
            viewer.gesture = gesture.copy(x = x.within(viewer.viewport.visible), y = y)
            hover(x)
        }
    }

    /** It ends. */
    fun end() {
        val gesture = viewer.gesture ?: return
        viewer.gesture = null
        when (gesture.kind) {
            DragKind.ZOOM -> if (gesture.xSpan.width > 0) viewer.viewport = viewer.viewport.showing(gesture.startX, gesture.x)

            DragKind.ZOOM_Y -> if (gesture.graph != null && gesture.ySpan.width > 0) {
                viewer.graphs = viewer.graphs.withYRange(gesture.graph, gesture.ySpan)
            }

            DragKind.SELECT -> viewer.selection = gesture.xSpan.takeIf { it.width > 0 }

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
            viewer.viewport,
            right.toDouble(),
            down.toDouble(),
            ctrl,
            shift,
            x,
            width.toDouble(),
            millis.toDouble(),
        )
        turned?.let { viewer.viewport = it }
        return turned != null
    }

    private fun Double.within(span: Span) = coerceIn(span.from, span.to)
}

/**
 * Gives up what a person is in the middle of: a drag, else the selection, else the pinned cursor, else the cursor.
 *
 * @return whether there was anything.
 */
internal fun giveUpGesture(viewer: Viewer): Boolean {
    val gesture = viewer.gesture
    when {
        gesture != null -> {
            viewer.gesture = null
            viewer.viewport = gesture.before
        }

        viewer.selection != null -> viewer.selection = null

        viewer.isCursorPinned -> viewer.isCursorPinned = false

        viewer.cursor != null -> viewer.cursor = null

        else -> return false
    }
    return true
}
