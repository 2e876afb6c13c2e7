package badlog.window.log

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import badlog.viewer.draw.mark.EventTimeline
import badlog.window.state.StateHolder

/** The recording that the window shows, if any. */
internal class CurrentRecording : StateHolder<OpenRecording?>(null) {
    /** The recording; null before one was opened, and after it was closed. */
    val recording: OpenRecording? get() = state

    /** Shows [recording] from now on: another one, or the same file read or calculated again. */
    fun replace(recording: OpenRecording) = change { recording }

    /** Shows no recording from now on. */
    fun close() = change { null }
}

/** The events of the [current] recording, and the filter for listed and marked events. */
internal class FilteredEvents(private val current: CurrentRecording) : StateHolder<EventFilter>(EventFilter()) {
    /** The events that pass the filter. */
    val matching: EventTimeline by derivedStateOf { current.recording?.let { state.over(it.events, it.eventLogs) } ?: EventTimeline.NONE }
}
