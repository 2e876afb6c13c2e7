package badlog.viewer.choices.board

import badlog.core.analysis.Graph

/**
 * Returns [graphs] of a folder grouped by frame: each by itself, except that neighbors that show states are together, each with a lane,
 * as many as fit on a screen.
 *
 * @param isAlone whether a graph stays by itself although it shows states.
 */
fun framesOf(graphs: List<Graph>, isAlone: (Graph) -> Boolean = { false }): List<List<Graph>> {
    val frames = ArrayList<MutableList<Graph>>()
    for (graph in graphs) {
        val last = frames.lastOrNull()
        val isJoined = graph.showsStates && !isAlone(graph) && last != null && last.first().showsStates && !isAlone(last.first())
        if (isJoined && last.sumOf { it.series.size } + graph.series.size <= MAX_LANES) last += graph else frames += mutableListOf(graph)
    }
    return frames
}

/** Returns the title of a frame with the states of several graphs of [folder], including the folder. */
fun statesTitle(folder: String): String = if (folder.isEmpty()) "States" else "$folder/States"

/** Returns the graph of all lanes of [frame], one of those from [framesOf]. */
fun laneGraphOf(frame: List<Graph>): Graph {
    val first = frame.first()
    if (frame.size == 1) return first
    return Graph(statesTitle(first.folder), first.unit, isVirtual = false, first.isFilled, first.includesZero, frame.flatMap { it.series })
}

private const val MAX_LANES = 16
