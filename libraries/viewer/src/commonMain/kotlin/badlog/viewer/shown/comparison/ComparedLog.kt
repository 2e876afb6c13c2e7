package badlog.viewer.shown.comparison

import badlog.core.analysis.Graph
import badlog.core.analysis.GraphSeries
import badlog.viewer.choices.board.BoardLines

/**
 * A log that is drawn over the open one.
 *
 * @property name its name beside the others.
 * @param lines its lines.
 * @property offset what is added to its x.
 */
class ComparedLog(val name: String, private val lines: BoardLines, val offset: Double) {
    private val moved = HashMap<String, GraphSeries?>()

    /** Returns its line [line] where it is drawn, with the log's name behind its own; null if it has none. */
    operator fun get(line: String): GraphSeries? = moved.getOrPut(line) { lines[line]?.moved(offset, " ($name)") }
}

/** A graph of a log with lines of others among its own, and the board's name of each line. */
class ComparedGraph(val graph: Graph, val lines: List<String>)

/**
 * Returns [graph], whose lines the board calls [lines], with the same lines of [logs]: each follows the line of the open log, so that the
 * color shows first which log it is.
 */
fun comparedGraph(graph: Graph, lines: List<String>, logs: List<ComparedLog>): ComparedGraph {
    if (logs.isEmpty()) return ComparedGraph(graph, lines)
    val series = ArrayList<GraphSeries>()
    val names = ArrayList<String>()
    graph.series.forEachIndexed { i, own ->
        val others = logs.mapNotNull { log -> log[lines[i]]?.takeIf { (it.states == null) == (own.states == null) } }
        series += own
        series += others
        repeat(1 + others.size) { names += lines[i] }
    }
    return ComparedGraph(Graph(graph.name, graph.unit, graph.isVirtual, graph.isFilled, graph.includesZero, series), names)
}
