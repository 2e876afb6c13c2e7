package badlog.viewer.topic

import badlog.viewer.board.GraphBoard
import badlog.viewer.board.GraphList
import badlog.viewer.panels.InspectorTab
import badlog.viewer.panels.WindowPanels
import badlog.viewer.recording.CurrentRecording
import badlog.viewer.recording.EventFilter
import badlog.viewer.recording.FilteredEvents
import badlog.viewer.recording.OpenRecording
import badlog.viewer.recording.Signal

/** Whether [signal] is a list of what happened, which no line draws. */
internal fun OpenRecording.isEvents(signal: Signal): Boolean = !signal.isDerived && signal.topic.samples.isEmpty() && signal.states == null

/** Gives [signal] a graph of its own, or takes that away; of events, opens the list. */
internal fun toggleDrawn(current: CurrentRecording, board: GraphBoard, events: FilteredEvents, panels: WindowPanels, signal: Signal) {
    if (current.recording?.isEvents(signal) == true) {
        events.change { EventFilter(topics = setOf(signal.name)) }
        panels.change { inspecting(InspectorTab.EVENTS) }
    } else {
        board.change { withOwnToggled(signal.name) }
    }
}

/** Adds [names] to the last graph, or to a new one where there is none. */
internal fun GraphList.withLinesInLast(names: List<String>): GraphList {
    val last = graphs.lastOrNull() ?: return withGraph(names)
    return names.fold(this) { list, name -> list.withLine(last.id, name) }
}

/** Adds a graph of [name] alone, or takes those away that are there. */
internal fun GraphList.withOwnToggled(name: String): GraphList {
    val own = graphs.filter { graph -> graph.lines.size == 1 && graph.lines[0].signal == name }
    return if (own.isEmpty()) withGraph(listOf(name)) else own.fold(this) { list, graph -> list.without(graph.id) }
}

/** For each signal that is drawn, the place of its line in the first graph that draws it. */
internal fun GraphList.placesOfLines(): Map<String, Int> {
    val places = HashMap<String, Int>()
    for (graph in graphs) graph.lines.forEachIndexed { place, line -> places.putIfAbsent(line.signal, place) }
    return places
}
