package badlog.viewer.topic

import badlog.plot.board.Board
import badlog.viewer.board.GraphBoard
import badlog.viewer.panels.InspectorTab
import badlog.viewer.panels.WindowPanels
import badlog.viewer.recording.CurrentRecording
import badlog.viewer.recording.EventFilter
import badlog.viewer.recording.FilteredEvents
import badlog.viewer.recording.OpenRecording
import badlog.viewer.recording.Signal

/** Whether [signal] is a list of what happened, which no line draws. */
internal fun OpenRecording.isEvents(signal: Signal): Boolean = !signal.isDerived && signal.topic.samples.isEmpty() && signal.states == null

/**
 * Gives [signal] a graph of its own, goes to that where it is out of sight, or else takes it away; of events, opens the list.
 */
internal fun toggleDrawn(current: CurrentRecording, board: GraphBoard, events: FilteredEvents, panels: WindowPanels, signal: Signal) {
    if (current.recording?.isEvents(signal) == true) {
        events.change { EventFilter(topics = setOf(signal.name)) }
        panels.change { inspecting(InspectorTab.EVENTS) }
        return
    }
    val own = board.state.graphs.filter { it.lines == listOf(signal.name) }
    val seen = board.inSight
    if (own.isNotEmpty() && seen != null &&
        own.none { it.id in seen }
    ) {
        board.goTo(own[0].id)
    } else {
        board.change { withOwnToggled(signal.name) }
    }
}
