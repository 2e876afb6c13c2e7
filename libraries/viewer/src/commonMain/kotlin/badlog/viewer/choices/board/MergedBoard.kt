package badlog.viewer.choices.board

import badlog.viewer.choices.merged
import badlog.viewer.choices.mergedWith

/**
 * Returns this board merged with the changes that others made to the [stored] board since this one [read] it. Several tabs or windows
 * change such a board, and remember it in one place. Graphs are merged one by one; within a graph, title, lines and height are merged
 * separately. See [mergedWith][badlog.viewer.choices.mergedWith].
 *
 * @param stored the currently stored board.
 */
fun Board.mergedWith(stored: Board, read: Board): Board {
    val known = read.graphs.mapTo(HashSet()) { it.id }
    val own = graphs.filter { it.id !in known }.associateBy { it.id }
    // Ids of new graphs may be equal by chance.
    var free = (graphs + stored.graphs).maxOfOrNull { it.id } ?: 0
    val others = stored.graphs.map { graph ->
        val isFree = own[graph.id].let { it == null || it == graph || it.id == it.idOfLines || graph.id == graph.idOfLines }
        if (isFree) graph else graph.copy(id = ++free)
    }
    val merged = graphs.mergedWith(others, read.graphs, { it.id }) { mine, before, theirs ->
        if (before == null) mine else mine.mergedWith(theirs, before)
    }
    return Board(merged.filter { it.lines.isNotEmpty() })
}

private fun BoardGraph.mergedWith(stored: BoardGraph, read: BoardGraph): BoardGraph {
    fun <T> of(part: (BoardGraph) -> T): T = merged(part(this), part(read), part(stored))

    fun names(part: (BoardGraph) -> Iterable<String>) = part(this).toList().mergedWith(part(stored).toList(), part(read).toList())

    val lines = names { it.lines }
    val hidden = names { it.hidden }.filterTo(HashSet()) { it in lines }
    // The other properties depend on each other: a fixed part of y is not shared, for example.
    val rest = of { it.copy(title = "", lines = emptyList(), height = null, hidden = emptySet()) }
    return rest.copy(title = of { it.title }, lines = lines, height = of { it.height }, hidden = hidden)
}
