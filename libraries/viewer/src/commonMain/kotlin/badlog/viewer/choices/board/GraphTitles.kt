package badlog.viewer.choices.board

import badlog.core.text.UniqueNames
import badlog.viewer.text.shortNames

/** The titles of the graphs in order, each once: of those that are equal, all but the first end with a number, as in `Speed (2)`. */
val Board.titles: List<String> get() = numbered(graphs.map { it.title })

/**
 * The same, each with only as much of its path as tells it from the others: `Left/Speed` and `Right/Speed`. A title that lists several
 * lines stays whole, since what follows its last slash is only the end of the last one.
 */
val Board.shortTitles: List<String>
    get() {
        val (paths, lists) = graphs.partition { it.isTitledByPath }
        val short = paths.map { it.id }.zip(shortNames(paths.map { it.title })).toMap() + lists.associate { it.id to it.title }
        return numbered(graphs.map { short.getValue(it.id) })
    }

/** Returns which of [titles] is that of [graph], or its own title if it is not one of the graphs. */
fun Board.titleOf(graph: BoardGraph): String = titles.getOrElse(graphs.indexOfFirst { it.id == graph.id }) { graph.title }

/** Whether the title is a path, of a topic or a joined graph, and not a list of lines as [evidenceBoard] makes it. */
val BoardGraph.isTitledByPath: Boolean get() = title in lines || LIST_SEPARATOR !in title

private fun numbered(titles: List<String>): List<String> = UniqueNames().run { titles.map(::give) }

private const val LIST_SEPARATOR = ", "
