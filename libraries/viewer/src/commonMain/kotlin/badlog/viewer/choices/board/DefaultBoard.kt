package badlog.viewer.choices.board

import badlog.core.analysis.Graph
import badlog.core.analysis.LogView
import badlog.viewer.shown.outline.everChanges

/**
 * Returns the graphs that the attributes of a recording's topics define, in order. Neighboring states of a folder share a graph with a
 * lane for each, as many as fit on a screen. The x axis does not have a graph. Topics with their own times, as in a WPILOG with
 * everything from a dashboard, are omitted if they never change, unless nothing changes.
 */
fun defaultBoard(view: LogView): Board {
    val hasChanges = view.folders.any { folder -> folder.graphs.any(::changes) }
    val specs = view.folders.flatMap { folder ->
        val graphsOfFolder = folder.graphs.filter { graph ->
            graph.series.any { it.isDerived || it.topic !== view.xAxis.topic } && (!hasChanges || changes(graph))
        }
        framesOf(graphsOfFolder).map { graphs ->
            val first = graphs.first().asBoardGraph()
            if (graphs.size == 1) return@map first
            first.copy(title = statesTitle(folder.name), lines = graphs.flatMap { it.asBoardGraph().lines }.distinct())
        }
    }
    return Board(specs).identifiedByLines()
}

private fun changes(graph: Graph) = graph.series.any { it.topic.times == null || everChanges(it.topic) }
