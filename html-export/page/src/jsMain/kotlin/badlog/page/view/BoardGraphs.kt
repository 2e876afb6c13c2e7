package badlog.page.view

import badlog.core.analysis.Graph
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.BoardLines

/**
 * Returns the graphs that draw [spec]: numbers first, then states, which cannot share a frame with numbers. Each graph comes with the
 * board's names for its lines, as far as [lines] contains them.
 */
internal fun graphsOf(spec: BoardGraph, lines: BoardLines): List<Pair<Graph, List<String>>> {
    val found = spec.lines.mapNotNull { name -> lines[name]?.let { name to it } }
    return found.partition { (_, line) -> line.states == null }.toList().filter { it.isNotEmpty() }.map { part ->
        val series = part.map { it.second }
        Graph(spec.title, series[0].unit, isVirtual = false, spec.isFilled, spec.includesZero, series) to part.map { it.first }
    }
}
