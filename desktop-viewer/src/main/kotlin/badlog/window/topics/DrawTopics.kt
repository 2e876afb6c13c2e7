package badlog.window.topics

import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.shown.outline.withCounterparts
import badlog.viewer.state.GraphChange
import badlog.window.log.CurrentRecording
import badlog.window.log.DrawableTopic
import badlog.window.log.EventFilter
import badlog.window.log.FilteredEvents
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.WindowPanels

/** Returns whether [signal] is a list of events, which is not drawn as a line. */
internal fun OpenRecording.isEvents(signal: DrawableTopic): Boolean =
    !signal.isDerived && !signal.isEmpty && signal.topic.samples.isEmpty() && signal.states == null

/** Returns the graph to which a click adds a topic; null if each topic gets its own graph. */
internal fun targetOf(board: GraphBoard, topics: TopicListing): BoardGraph? =
    topics.state.target?.let { id -> board.state.graphs.find { it.id == id } }

/** Adds [signal] to the graph of [targetOf] or removes it; if there is none, toggles its own graph, see [toggleDrawn]. */
internal fun toggleIn(
    current: CurrentRecording,
    board: GraphBoard,
    events: FilteredEvents,
    topics: TopicListing,
    panels: WindowPanels,
    signal: DrawableTopic,
) {
    val target = targetOf(board, topics)
    if (target == null || signal.isEmpty || current.recording?.isEvents(signal) == true) {
        return toggleDrawn(current, board, events, panels, signal)
    }
    board.send(GraphChange.ToggleLine(target.id, signal.name))
}

/**
 * Adds a graph for [signal], together with its target or actual value. If the graph exists already, scrolls to it if it is out of sight,
 * otherwise removes it. For events, opens the list.
 */
internal fun toggleDrawn(
    current: CurrentRecording,
    board: GraphBoard,
    events: FilteredEvents,
    panels: WindowPanels,
    signal: DrawableTopic,
) {
    if (signal.isEmpty) return
    if (current.recording?.isEvents(signal) == true) {
        events.change { EventFilter(topics = setOf(signal.name)) }
        // A person who selects topics goes on with that.
        panels.change { inspecting(InspectorTab.EVENTS).withTopics() }
        return
    }
    val names = current.recording?.takeIf { !signal.isDerived }?.let { withCounterparts(it.view, signal.name) } ?: listOf(signal.name)
    val own = board.state.graphs.filter { it.lines == listOf(signal.name) || it.lines == names }
    val seen = board.inSight
    if (own.isNotEmpty() && seen != null && own.none { it.id in seen }) {
        board.goTo(own[0].id)
    } else {
        board.send(GraphChange.ToggleOwn(signal.name, names))
    }
}
