package badlog.plot.lane

import badlog.analysis.Graph

/**
 * [graphs] of a folder by what shares a frame: each by itself, but neighbors that show states together, each with a lane, up to so many
 * that they still fit a screen.
 *
 * @param isAlone whether a graph is to stay by itself though it shows states.
 */
public fun framesOf(graphs: List<Graph>, isAlone: (Graph) -> Boolean = { false }): List<List<Graph>> {
    val frames = ArrayList<MutableList<Graph>>()
    for (graph in graphs) {
        val last = frames.lastOrNull()
        val isJoined = graph.showsStates && !isAlone(graph) && last != null && last.first().showsStates && !isAlone(last.first())
        if (isJoined && last.sumOf { it.series.size } + graph.series.size <= MAX_LANES) last += graph else frames += mutableListOf(graph)
    }
    return frames
}

/** The title of a frame with the states of several graphs of [folder], with the folder. */
public fun statesTitle(folder: String): String = if (folder.isEmpty()) "States" else "$folder/States"

/** The graph of all lanes of [frame], one of [framesOf]. */
public fun laneGraphOf(frame: List<Graph>): Graph {
    val first = frame.first()
    if (frame.size == 1) return first
    return Graph(statesTitle(first.folder), first.unit, isVirtual = false, first.isFilled, first.includesZero, frame.flatMap { it.series })
}

private const val MAX_LANES = 16
