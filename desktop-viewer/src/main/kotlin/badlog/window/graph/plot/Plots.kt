package badlog.window.graph.plot

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.unit.IntSize
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.range.holdsUntil
import badlog.viewer.choices.range.stateRuns
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.plot.GraphLine
import badlog.viewer.shown.comparison.colorOf
import badlog.viewer.text.shortNames
import badlog.window.compare.DrawnRecording
import badlog.window.log.DrawableTopic
import badlog.window.log.OpenRecording
import java.util.WeakHashMap
import java.util.concurrent.ConcurrentHashMap

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

/**
 * The curves and states of each signal, calculated once and used for every zoom. They are released with their recording. Use it on any
 * thread except the window's, because the first use of a signal takes a while.
 */
internal class CurveCache {
    private class OfRecording {
        val curves = ConcurrentHashMap<String, SharedCurve>()
        val runs = ConcurrentHashMap<String, StateRuns>()
    }

    private val byRecording = WeakHashMap<OpenRecording, OfRecording>()

    /** Returns the curve of [signal], which belongs to [recording]. */
    fun curve(recording: OpenRecording, signal: DrawableTopic): SharedCurve = of(recording).curves.computeIfAbsent(signal.name) {
        SharedCurve(signal.series, signal.line.holdsUntil)
    }

    /** Returns the states of [signal], which belongs to [recording]. */
    fun runs(recording: OpenRecording, signal: DrawableTopic): StateRuns =
        of(recording).runs.computeIfAbsent(signal.name) { signal.line.stateRuns() }

    private fun of(recording: OpenRecording) = synchronized(byRecording) { byRecording.getOrPut(recording, ::OfRecording) }
}

/**
 * The curve of a series, shared by threads: only one thread at a time can use a curve.
 *
 * @param holdsUntil the x until which the last value holds, if values hold; see [Curve].
 */
internal class SharedCurve(series: Series, holdsUntil: Double?) {
    private val curve = Curve(series, holdsUntil)
    private var columns = PixelColumns(0)

    /** Returns the strokes for [visible] on [width] pixels, with y as logged. The scale of y depends on all lines of a graph. */
    @Synchronized
    fun trace(visible: Span, width: Int): Strokes {
        if (columns.count != width) columns = PixelColumns(width)
        curve.draw(visible.from, visible.to, columns)
        return Strokes().apply { trace(curve, Scale.ofX(visible, width.toDouble()), Scale.NONE) }
    }
}

/**
 * One line on the screen: a signal of a recording.
 *
 * @property offset the number added to the recording's x to get the window's x.
 * @property color the index of its color in the palette, from 0.
 * @property title its name in the graph: the part of its path that distinguishes it from the other lines; in brackets if it was calculated.
 * @property label an addition to the signal's name in the legend, if that is not enough; otherwise null.
 */
internal data class DrawnLine(
    val signal: DrawableTopic,
    val recording: OpenRecording,
    override val offset: Double,
    override val color: Int,
    val title: String = signal.title,
    val label: String? = null,
) : GraphLine {
    override val series: GraphSeries get() = signal.line
}

/** Returns the lines of [spec] in each of [recordings] that has them. */
internal fun drawnLines(spec: BoardGraph, recordings: List<DrawnRecording>): List<DrawnLine> {
    val isCompared = recordings.size > 1
    val titles = shortNames(spec.lines)
    return spec.lines.flatMapIndexed { place, name ->
        recordings.mapIndexedNotNull { index, drawn ->
            val signal = drawn.recording.signal(name) ?: return@mapIndexedNotNull null
            DrawnLine(
                signal = signal,
                recording = drawn.recording,
                offset = drawn.offset,
                color = colorOf(place, index, recordings.size),
                title = if (signal.isDerived) "[ ${titles[place]} ]" else titles[place],
                label = if (isCompared) drawn.name else null,
            )
        }
    }
}
