package badlog.window.graph.plot

import badlog.core.analysis.StateRuns
import badlog.viewer.choices.range.holdsUntil
import badlog.viewer.choices.range.stateRuns
import badlog.window.log.DrawableTopic
import badlog.window.log.OpenRecording
import java.util.WeakHashMap
import java.util.concurrent.ConcurrentHashMap

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
