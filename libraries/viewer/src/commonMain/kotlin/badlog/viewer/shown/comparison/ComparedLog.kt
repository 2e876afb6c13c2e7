package badlog.viewer.shown.comparison

import badlog.core.analysis.Graph
import badlog.core.analysis.GraphSeries
import badlog.viewer.choices.board.BoardLines

/** A log among those that graphs draw. */
interface DrawnLog {
    /** Its name beside the others. */
    val name: String

    /** The number that is added to its x, to align it with the open one. */
    val offset: Double
}

/**
 * A log that is drawn over the open one.
 *
 * @property lines the lines of the log, at their logged x.
 */
class ComparedLog(override val name: String, val lines: BoardLines, override val offset: Double) : DrawnLog {
    private val moved = HashMap<String, GraphSeries?>()
    internal val suffix = " ($name)"

    /** Returns the line [line] where it is drawn, with the log's name after its own. Null if the log does not have it. */
    operator fun get(line: String): GraphSeries? = moved.getOrPut(line) { lines[line]?.moved(offset, suffix) }
}

/**
 * A graph of a log with lines of others among its own.
 *
 * @property lines the board's name of each line.
 * @property names the same names, each with the line's log unless that is the open one.
 * @property colors the index of each line's color.
 */
class ComparedGraph(val graph: Graph, val lines: List<String>, val names: List<String>, val colors: List<Int>)

/**
 * Returns the index of the color of the line at [place] in a graph of log [index]. [count] logs are drawn. The color distinguishes logs
 * first: it is the same in all graphs, even if a log lacks a line.
 */
fun colorOf(place: Int, index: Int, count: Int): Int = place * count + index

/** Returns [graph] with the same lines of [logs] added. [lines] has the board's names for its lines. */
fun comparedGraph(graph: Graph, lines: List<String>, logs: List<ComparedLog>): ComparedGraph {
    if (logs.isEmpty()) return ComparedGraph(graph, lines, lines, lines.indices.toList())
    val series = ArrayList<GraphSeries>()
    val drawn = ArrayList<String>()
    val names = ArrayList<String>()
    val colors = ArrayList<Int>()
    graph.series.forEachIndexed { i, own ->
        val all = listOf(own) + logs.map { log -> log[lines[i]]?.takeIf { (it.states == null) == (own.states == null) } }
        all.forEachIndexed { log, line ->
            if (line == null) return@forEachIndexed
            series += line
            drawn += lines[i]
            names += lines[i] + if (log > 0) logs[log - 1].suffix else ""
            colors += colorOf(i, log, all.size)
        }
    }
    return ComparedGraph(Graph(graph.name, graph.unit, graph.isVirtual, graph.isFilled, graph.includesZero, series), drawn, names, colors)
}

/**
 * The possible names of a log.
 *
 * @property event the event; null if unknown.
 * @property match the match within its event, such as `Qualification 42`; null if unknown.
 * @property label the displayed name of the log alone.
 * @property path the path of the file, with all known folders, separated by `/`.
 */
class LogName(val event: String?, val match: String?, val label: String, val path: String)

/**
 * Returns the names of [logs] beside each other, in order. A name is only the match if all logs are of the same event. Equal names are
 * followed by the files' names, with as many folders as distinguish them.
 */
fun namesBeside(logs: List<LogName>): List<String> {
    val isOneEvent = logs.mapNotNull { it.event }.distinct().size <= 1
    val names = logs.map { log -> log.match?.takeIf { isOneEvent } ?: log.label }
    if (names.areDistinct) return names
    val paths = logs.map { it.path.split('/') }
    val ends = (1..paths.maxOf { it.size }).asSequence().map { depth -> paths.map { it.takeLast(depth).joinToString("/") } }
    val files = ends.firstOrNull { it.areDistinct } ?: ends.last()
    return names.mapIndexed { i, name -> "$name (${files[i]})" }
}

private val List<String>.areDistinct get() = distinct().size == size

/** Returns [label] in at most [letters] characters, shortened in the middle if necessary. Matches of one event differ at their end. */
fun shortLabel(label: String, letters: Int): String {
    if (label.length <= letters) return label
    val end = (letters - 1) / 2
    return label.take(letters - 1 - end).trimEnd() + "…" + label.takeLast(end).trimStart()
}
