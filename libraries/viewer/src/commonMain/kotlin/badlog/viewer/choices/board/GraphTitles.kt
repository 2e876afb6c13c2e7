package badlog.viewer.choices.board

import badlog.core.text.UniqueNames
import badlog.viewer.text.shortNames

/** The titles of the graphs in order, made unique. Repeated titles end with a number, as in `Speed (2)`. */
val Board.titles: List<String> get() = numbered(graphs.map { it.title })

/**
 * The titles with only as much of each path as distinguishes it from the others: `Left/Speed` and `Right/Speed`. A title that lists
 * several lines stays whole, because its last slash belongs to the last line only.
 */
val Board.shortTitles: List<String>
    get() {
        val (paths, lists) = graphs.partition { it.isTitledByPath }
        val short = paths.map { it.id }.zip(shortNames(paths.map { it.title })).toMap() + lists.associate { it.id to it.title }
        return numbered(graphs.map { short.getValue(it.id) })
    }

/** Returns the title of [graph] among the [titles], or its own title if it is not on the board. */
fun Board.titleOf(graph: BoardGraph): String = titles.getOrElse(graphs.indexOfFirst { it.id == graph.id }) { graph.title }

/** Whether the title is the path of a topic or a joined graph. Otherwise it is a list of lines from [evidenceBoard]. */
val BoardGraph.isTitledByPath: Boolean get() = title in lines || LIST_SEPARATOR !in title

private fun numbered(titles: List<String>): List<String> = UniqueNames().run { titles.map(::give) }

private const val LIST_SEPARATOR = ", "
