package badlog.viewer.graph.plot

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.unit.IntSize
import badlog.analysis.Span
import badlog.viewer.compare.DrawnRecording

/** What a graph on the screen has: its size, and its latest picture. */
internal class PlotState {
    /** The room for lines and lanes, in physical pixels; zero before it is known. */
    var size: IntSize by mutableStateOf(IntSize.Zero)

    /** What is drawn; null before the first is there. */
    var picture: PlotPicture? by mutableStateOf(null)
}

/** The pictures of all graphs of a window. To be used on the window's thread only. */
internal class Plots {
    private val states = HashMap<Int, PlotState>()
    private var onScreen by mutableStateOf(emptySet<Int>())
    private var needNone by mutableStateOf(emptySet<Int>())

    /** What serves all pictures. */
    val curves = CurveCache()

    /** What graph [id] has; kept while it is out of sight, so that it is there at once when it comes back. */
    fun state(id: Int): PlotState = states.getOrPut(id, ::PlotState)

    /** Graph [id] comes into sight, or goes; it waits for a picture where it [needsPicture]. */
    fun show(id: Int, isOnScreen: Boolean, needsPicture: Boolean = true) {
        onScreen = if (isOnScreen) onScreen + id else onScreen - id
        needNone = if (isOnScreen && !needsPicture) needNone + id else needNone - id
    }

    /**
     * Forgets the graphs that are not among [ids], and what those out of sight show of others than [recordings]: it would keep all
     * their samples in memory.
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

    /** Whether every graph in sight has the picture of [recordings] for [visible]; false when none is in sight. */
    fun areReady(recordings: List<DrawnRecording>, visible: Span): Boolean = onScreen.isNotEmpty() && onScreen.all { id ->
        id in needNone || state(id).picture?.request?.let { it.visible == visible && it.recordings == recordings } == true
    }
}

/** The overview's place among the graphs, which count from 1. */
internal const val OVERVIEW = 0
