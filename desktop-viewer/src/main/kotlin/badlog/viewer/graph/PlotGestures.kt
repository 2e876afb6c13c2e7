package badlog.viewer.graph

import badlog.analysis.Span
import badlog.viewer.app.Viewer
import kotlin.math.abs
import kotlin.math.exp

/** What the pointer does over the graphs, in places on the axes rather than pixels. */
internal class PlotGestures(private val viewer: Viewer) {
    private var lastWheel = Long.MIN_VALUE / 2

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
    fun begin(kind: GestureKind, id: Int?, x: Double, y: Double) {
        viewer.gesture = PlotGesture(kind, id, x, y, viewer.viewport)
        if (kind == GestureKind.PAN) viewer.viewport = viewer.viewport.remembered()
    }

    /** It goes on to [x] and [y]. */
    fun drag(x: Double, y: Double) {
        val gesture = viewer.gesture ?: return
        if (gesture.kind == GestureKind.PAN) {
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
            GestureKind.ZOOM -> if (gesture.xSpan.width > 0) viewer.viewport = viewer.viewport.showing(gesture.startX, gesture.x)

            GestureKind.ZOOM_Y -> if (gesture.graph != null && gesture.ySpan.width > 0) {
                viewer.graphs = viewer.graphs.withYRange(gesture.graph, gesture.ySpan)
            }

            GestureKind.SELECT -> viewer.selection = gesture.xSpan.takeIf { it.width > 0 }

            GestureKind.PAN -> Unit
        }
    }

    /** The wheel turns by [notches], forwards when negative, over [x]; [millis] is the time of any clock. */
    fun zoom(notches: Float, x: Double, millis: Long) {
        rememberFirst(millis)
        val factor = exp(notches.coerceIn(-MOST_NOTCHES, MOST_NOTCHES) * NOTCH)
        viewer.viewport = viewer.viewport.scaled(factor, x)
    }

    /** The wheel, or two fingers, go sideways by [notches]. */
    fun pan(notches: Float, millis: Long) {
        rememberFirst(millis)
        viewer.viewport = viewer.viewport.shifted(notches * SIDEWAYS * viewer.viewport.visible.width)
    }

    // Turns that follow one another closely are one step back.
    private fun rememberFirst(millis: Long) {
        if (millis - lastWheel > PAUSE_MILLIS) viewer.viewport = viewer.viewport.remembered()
        lastWheel = millis
    }

    private fun Double.within(span: Span) = coerceIn(span.from, span.to)

    private companion object {
        const val NOTCH = 0.2
        const val MOST_NOTCHES = 4f
        const val SIDEWAYS = 0.06
        const val PAUSE_MILLIS = 500L
    }
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
