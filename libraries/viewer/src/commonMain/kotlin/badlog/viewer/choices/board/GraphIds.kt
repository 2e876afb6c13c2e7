package badlog.viewer.choices.board

/**
 * Returns the same board with ids derived from the lines of its graphs. Tabs and windows that begin with the same graph, even for different
 * logs, then recognize it as the same.
 */
fun Board.identifiedByLines(): Board {
    val taken = HashSet<Int>()
    return Board(
        graphs.map { graph ->
            var id = graph.idOfLines
            while (!taken.add(id)) id++
            graph.copy(id = id)
        },
    )
}

/** The id derived from the graph's lines, which it has unless that id is taken on its board. */
internal val BoardGraph.idOfLines: Int get() = (lines.hashCode() * 2 + (if (isXy) 1 else 0)) and Int.MAX_VALUE
