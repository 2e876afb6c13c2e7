package badlog.viewer.board

import badlog.analysis.Span
import badlog.viewer.part.Part

/**
 * The graphs of the window, from top to bottom. Never changes; each transition gives a new one.
 *
 * @property graphs them.
 */
internal data class GraphList(val graphs: List<GraphSpec> = emptyList()) {
    private val nextId: Int get() = (graphs.maxOfOrNull { it.id } ?: 0) + 1

    /** Adds a graph of the signals [names] at the end, or before the graph [before]. */
    fun withGraph(names: List<String>, before: Int? = null): GraphList {
        if (names.isEmpty()) return this
        val graph = GraphSpec(nextId, names.first(), names.distinct().map(::LineSpec))
        val place = graphs.indexOfFirst { it.id == before }.let { if (it < 0) graphs.size else it }
        return copy(graphs = graphs.take(place) + graph + graphs.drop(place))
    }

    /** Adds the signal [name] to graph [id], where it is not there yet. */
    fun withLine(id: Int, name: String): GraphList =
        change(id) { if (it.lines.any { line -> line.signal == name }) it else it.copy(lines = it.lines + LineSpec(name)) }

    /** Takes the signal [name] out of graph [id], which goes with its last line. */
    fun withoutLine(id: Int, name: String): GraphList {
        val changed = change(id) { it.copy(lines = it.lines.filterNot { line -> line.signal == name }) }
        return changed.copy(graphs = changed.graphs.filter { it.lines.isNotEmpty() })
    }

    /** Takes the signal [name] out of all graphs; those with no other line go with it. */
    fun withoutSignal(name: String): GraphList = graphs.fold(this) { list, graph ->
        if (graph.lines.any { it.signal == name }) list.withoutLine(graph.id, name) else list
    }

    /** Draws the signal [name] where [before] was drawn. */
    fun renamed(before: String, name: String): GraphList = copy(
        graphs = graphs.map { graph ->
            val lines = graph.lines.map { if (it.signal == before) it.copy(signal = name) else it }
            graph.copy(title = if (graph.title == before) name else graph.title, lines = lines.distinctBy { it.signal })
        },
    )

    /** Takes graph [id] away. */
    fun without(id: Int): GraphList = copy(graphs = graphs.filterNot { it.id == id })

    /** Moves graph [id] by [places], up when negative. */
    fun moved(id: Int, places: Int): GraphList {
        val from = graphs.indexOfFirst { it.id == id }
        if (from < 0) return this
        val to = (from + places).coerceIn(graphs.indices)
        return copy(graphs = graphs.toMutableList().apply { add(to, removeAt(from)) })
    }

    /** Shows only [range] of y in graph [id]; all of it for null. */
    fun withYRange(id: Int, range: Span?): GraphList = change(id) { it.copy(yRange = range) }

    private fun change(id: Int, to: (GraphSpec) -> GraphSpec) = copy(graphs = graphs.map { if (it.id == id) to(it) else it })
}

/** The graphs that the window shows, from top to bottom. */
internal class GraphBoard : Part<GraphList>(GraphList()) {
    /** Shows [graphs] instead. */
    fun replace(graphs: GraphList) = change { graphs }
}
