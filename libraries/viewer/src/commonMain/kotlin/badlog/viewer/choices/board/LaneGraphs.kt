package badlog.viewer.choices.board

import badlog.core.analysis.Graph

/**
 * Returns the [graphs] of a folder grouped by frame. Neighbors with states share a frame, with a lane for each, as many as fit on a screen.
 * Each other graph has its own frame.
 *
 * @param isAlone whether a graph has its own frame although it shows states.
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

/** Returns one graph with all lanes of [frame], which is one of the frames that [framesOf] returns. */
fun laneGraphOf(frame: List<Graph>): Graph {
    val first = frame.first()
    if (frame.size == 1) return first
    return Graph(statesTitle(first.folder), first.unit, isVirtual = false, first.isFilled, first.includesZero, frame.flatMap { it.series })
}

private const val MAX_LANES = 16
