package badlog.window.log

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import badlog.core.analysis.EventLog
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.shown.search.Query
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

/**
 * The filter for listed and marked events. Immutable; each transition returns a new one.
 *
 * @property text words that the text or the topic of an event must contain, regardless of case; empty for any.
 * @property topics the names of the topics with accepted events. If the recording has none of them, all topics are accepted.
 */
internal data class EventFilter(val text: String = "", val topics: Set<String> = emptySet()) {
    /** Returns the [events] that the filter accepts. They are the events of [logs]. */
    fun over(events: EventTimeline, logs: List<EventLog>): EventTimeline = events.matching(Query(text), topicsOf(logs))

    /** Returns the [topics] that [logs] contain. Some may be missing, because the filter stays when another recording is opened. */
    fun topicsOf(logs: List<EventLog>): Set<String> = logs.mapNotNullTo(HashSet()) { log -> log.name.takeIf { it in topics } }

    /** Adds [topic] to [topics], or removes it. */
    fun toggled(topic: String): EventFilter = copy(topics = if (topic in topics) topics - topic else topics + topic)
}
