package badlog.window.graph.plot

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.unit.IntSize
import badlog.core.analysis.Span
import badlog.window.compare.DrawnRecording

/** A graph on the screen: its size, and its latest picture. */
internal class PlotState {
    /** The size for lines and lanes, in physical pixels; zero until it is known. */
    var size: IntSize by mutableStateOf(IntSize.Zero)

    /** The drawn picture; null until there is one. */
    var picture: PlotPicture? by mutableStateOf(null)
}

/** The pictures of all graphs of a window. Use it only on the window's thread. */
internal class Plots {
    private val states = HashMap<Int, PlotState>()
    private var onScreen by mutableStateOf(emptySet<Int>())
    private var needNone by mutableStateOf(emptySet<Int>())

    /** The data shared by all pictures. */
    val curves = CurveCache()

    /** Returns the state of graph [id]; kept while it is invisible, so that it can be shown at once later. */
    fun state(id: Int): PlotState = states.getOrPut(id, ::PlotState)

    /** Records whether graph [id] is visible; if [needsPicture], it counts as ready only with a picture. */
    fun show(id: Int, isOnScreen: Boolean, needsPicture: Boolean = true) {
        onScreen = if (isOnScreen) onScreen + id else onScreen - id
        needNone = if (isOnScreen && !needsPicture) needNone + id else needNone - id
    }

    /**
     * Removes graphs that are not among [ids], and pictures of invisible graphs that show recordings other than [recordings]. Such pictures
     * would keep all samples of their recordings in memory.
     */
    fun keep(ids: Set<Int>, recordings: List<DrawnRecording>) {
        states.keys.retainAll(ids)
        onScreen = onScreen.intersect(ids)
        for ((id, state) in states) {
            val drawn = state.picture?.request?.recordings.orEmpty()
            val isOld = drawn.any { old -> recordings.none { it.recording === old.recording } }
            if (isOld && id !in onScreen && id != OVERVIEW) state.picture = null
        }
    }

    /** Returns whether every visible graph has its picture of [recordings] for [visible]; false if no graph is visible. */
    fun areReady(recordings: List<DrawnRecording>, visible: Span): Boolean = onScreen.isNotEmpty() && onScreen.all { id ->
        id in needNone || state(id).picture?.request?.let { it.visible == visible && it.recordings == recordings } == true
    }
}

/** The overview's id; the ids of graphs begin at 1. */
internal const val OVERVIEW = 0
