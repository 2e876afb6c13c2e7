package badlog.window.graph.plot

import badlog.core.analysis.StateRuns
import badlog.window.log.OpenRecording
import badlog.window.log.Signal
import java.util.WeakHashMap
import java.util.concurrent.ConcurrentHashMap

/**
 * What is calculated once for each signal and then used for every zoom. It is released with its recording. Use it on any thread
 * except the window's, because the first use of a signal takes a while.
 */
internal class CurveCache {
    private class OfRecording {
        val curves = ConcurrentHashMap<String, SharedCurve>()
        val runs = ConcurrentHashMap<String, StateRuns>()
    }

    private val byRecording = WeakHashMap<OpenRecording, OfRecording>()

    /** Returns the curve of [signal], one of [recording]'s. */
    fun curve(recording: OpenRecording, signal: Signal): SharedCurve = of(recording).curves.computeIfAbsent(signal.name) {
        SharedCurve(signal.series, recording.holdsUntil(signal))
    }

    /** Returns the states of [signal], one of [recording]'s. */
    fun runs(recording: OpenRecording, signal: Signal): StateRuns =
        of(recording).runs.computeIfAbsent(signal.name) { StateRuns(signal.series, recording.span.to) }

    private fun of(recording: OpenRecording) = synchronized(byRecording) { byRecording.getOrPut(recording, ::OfRecording) }
}
