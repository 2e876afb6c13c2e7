package badlog.viewer.recording

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import badlog.plot.timeline.EventTimeline
import badlog.viewer.part.Part

/** The recording that the window shows, if any. */
internal class CurrentRecording : Part<OpenRecording?>(null) {
    /** It; null before one was opened. */
    val recording: OpenRecording? get() = state

    /** Shows [recording] from now on: another one, or the same file read or calculated anew. */
    fun replace(recording: OpenRecording) = change { recording }
}

/** The events of the [current] recording, and which of them are listed and marked. */
internal class FilteredEvents(private val current: CurrentRecording) : Part<EventFilter>(EventFilter()) {
    /** Those that the filter lets through. */
    val matching: EventTimeline by derivedStateOf { current.recording?.let { state.over(it.events, it.eventLogs) } ?: EventTimeline.NONE }
}
