package badlog.viewer.choices.board

import badlog.core.analysis.Span
import badlog.signals.pose.Pose

/**
 * The graphs that a person put together. Immutable; each change returns a new board.
 *
 * @property graphs the graphs, from top to bottom.
 */
data class Board(val graphs: List<BoardGraph> = emptyList()) {
    private val nextId: Int get() = (graphs.maxOfOrNull { it.id } ?: 0) + 1

    /** Adds a graph of the signals [names] at the end, or before the graph [before]. */
    fun withGraph(names: List<String>, before: Int? = null): Board {
        if (names.isEmpty()) return this
        return withGraphs(listOf(BoardGraph(0, names.first(), names.distinct())), before)
    }

    /** Adds [added], with new ids, at the end, or before the graph [before]. */
    fun withGraphs(added: List<BoardGraph>, before: Int? = null): Board {
        val place = graphs.indexOfFirst { it.id == before }.let { if (it < 0) graphs.size else it }
        val first = nextId
        return copy(graphs = graphs.take(place) + added.mapIndexed { i, graph -> graph.copy(id = first + i) } + graphs.drop(place))
    }

    /** Replaces the graph that has the id of [graph]. */
    fun with(graph: BoardGraph): Board = change(graph.id) { graph }

    /** Adds the signal [name] to graph [id], if it is not there yet. */
    fun withLine(id: Int, name: String): Board = change(id) { if (name in it.lines) it else it.copy(lines = it.lines + name) }

    /** Adds to graph [id] each of the signals [names] that it lacks. */
    fun withLines(id: Int, names: List<String>): Board = names.fold(this) { board, name -> board.withLine(id, name) }

    /** Adds the signals [names] to the last graph, or to a new one if there is none. */
    fun withLinesInLast(names: List<String>): Board {
        val last = graphs.lastOrNull() ?: return withGraph(names)
        return withLines(last.id, names)
    }

    /**
     * Adds a graph of the signal [name], drawn as [lines]. If there are graphs of these lines or of the signal alone, removes them instead.
     */
    fun withOwnToggled(name: String, lines: List<String> = listOf(name)): Board {
        val own = graphs.filter { it.lines == listOf(name) || it.lines == lines }
        return if (own.isEmpty()) withGraph(lines) else own.fold(this) { board, graph -> board.without(graph.id) }
    }

    /** Returns whether this board has a graph that draws the same as [graph]. */
    fun has(graph: BoardGraph): Boolean = graphs.any { it.drawsAs(graph) }

    /** Adds [graph] at the end, or removes existing graphs that draw the same. */
    fun withToggled(graph: BoardGraph): Board =
        if (has(graph)) copy(graphs = graphs.filterNot { it.drawsAs(graph) }) else withGraphs(listOf(graph))

    /** Removes the signal [name] from graph [id]; a graph without lines is removed. */
    fun withoutLine(id: Int, name: String): Board {
        val changed = change(id) { it.copy(lines = it.lines - name, hidden = it.hidden - name) }
        return changed.copy(graphs = changed.graphs.filter { it.lines.isNotEmpty() })
    }

    /** Removes the signal [name] from all graphs; graphs without lines are removed. */
    fun withoutSignal(name: String): Board =
        graphs.fold(this) { board, graph -> if (name in graph.lines) board.withoutLine(graph.id, name) else board }

    /** Renames the signal [before] to [name] in all graphs. */
    fun renamed(before: String, name: String): Board = copy(
        graphs = graphs.map { graph ->
            fun nameNow(line: String) = if (line == before) name else line
            graph.copy(
                title = nameNow(graph.title),
                lines = graph.lines.map(::nameNow).distinct(),
                hidden = graph.hidden.mapTo(HashSet(), ::nameNow),
            )
        },
    )

    fun without(id: Int): Board = copy(graphs = graphs.filterNot { it.id == id })

    /** Moves graph [id] by [places], up if negative. */
    fun moved(id: Int, places: Int): Board {
        val from = graphs.indexOfFirst { it.id == id }
        if (from < 0) return this
        val to = (from + places).coerceIn(graphs.indices)
        return copy(graphs = graphs.toMutableList().apply { add(to, removeAt(from)) })
    }

    /** Moves graph [id] before the graph [other], or to the end if that is null. */
    fun movedBefore(id: Int, other: Int?): Board {
        val graph = graphs.find { it.id == id }
        if (graph == null || id == other) return this
        val others = without(id).graphs
        val place = others.indexOfFirst { it.id == other }.let { if (it < 0) others.size else it }
        return copy(graphs = others.take(place) + graph + others.drop(place))
    }

    /** Moves the lines of graph [other] to graph [id], and removes [other]. */
    fun joined(id: Int, other: Int): Board {
        val added = graphs.find { it.id == other }
        if (added == null || id == other || graphs.none { it.id == id }) return this
        return without(other).change(id) {
            it.copy(lines = (it.lines + added.lines).distinct(), hidden = it.hidden + (added.hidden - it.lines.toSet()))
        }
    }

    /**
     * Splits graph [id] into one graph over the common x for each line; the first one keeps the id. Ranges, hidden lines and the origin
     * of poses are reset.
     */
    fun separated(id: Int): Board {
        val first = nextId
        return copy(
            graphs = graphs.flatMap { graph ->
                if (graph.id != id || graph.lines.size < 2) return@flatMap listOf(graph)
                graph.lines.mapIndexed { i, line ->
                    graph.copy(
                        id = if (i == 0) id else first + i,
                        title = line,
                        lines = listOf(line),
                        yRange = null,
                        rightYRange = null,
                        hidden = emptySet(),
                        isXy = false,
                        xRange = null,
                        origin = FieldOrigin.BLUE,
                    )
                }
            },
        )
    }

    /**
     * Draws graph [id] as a graph of y over x if [isXy]. Poses become paths, other lines are drawn over the first one. Otherwise draws its
     * lines over the common x again.
     */
    fun withXy(id: Int, isXy: Boolean): Board = change(id) { it.copy(isXy = isXy, xRange = null, yRange = null) }

    /** Draws the first line of graph [id] over the second instead. */
    fun withSwappedAxes(id: Int): Board = change(id) { graph ->
        if (graph.lines.size < 2) return@change graph
        val (x, y) = graph.lines
        graph.copy(lines = listOf(y, x) + graph.lines.drop(2), xRange = graph.yRange, yRange = graph.xRange)
    }

    /** Shows only the ranges [x] and [y] in graph [id], a graph of y over x; null shows all of it. */
    fun withPlane(id: Int, x: Span?, y: Span?): Board = change(id) { it.copy(xRange = x, yRange = y) }

    /** Treats the poses of graph [id] as measured from [origin]. */
    fun withOrigin(id: Int, origin: FieldOrigin): Board = change(id) { it.copy(origin = origin) }

    /** Shows only [range] of y in graph [id], and [right] on its right axis; null shows all of y. A fixed range is not shared. */
    fun withYRange(id: Int, range: Span?, right: Span? = null): Board =
        change(id) { it.copy(yRange = range, rightYRange = right, sharesY = it.sharesY && range == null && right == null) }

    /** Makes graph [id] share its y range with all other such graphs, by unit, or stops sharing. */
    fun withSharedY(id: Int, shares: Boolean): Board = change(id) {
        if (shares) it.copy(sharesY = true, yRange = null, rightYRange = null) else it.copy(sharesY = false)
    }

    /** Hides or shows the line [name] of graph [id]; a hidden line stays in the graph. */
    fun withLineHidden(id: Int, name: String, isHidden: Boolean): Board =
        change(id) { if (name in it.lines) it.copy(hidden = if (isHidden) it.hidden + name else it.hidden - name) else it }

    /** Sets the height of graph [id], see [BoardGraph.height]; null for the default. */
    fun resized(id: Int, height: Int?): Board = change(id) { it.copy(height = height?.coerceIn(BoardGraph.HEIGHTS)) }

    /** Returns, for each drawn signal, the index of its line in the first graph that draws it. */
    fun placesOfLines(): Map<String, Int> {
        val places = HashMap<String, Int>()
        for (graph in graphs) graph.lines.forEachIndexed { place, line -> if (line !in places) places[line] = place }
        return places
    }

    /** Returns the same board with ids from 1 on, as after writing and reading it. */
    fun renumbered(): Board = Board(graphs.mapIndexed { i, graph -> graph.copy(id = i + 1) })

    /** Returns whether this board shows the same as [other], regardless of the ids. */
    fun showsSame(other: Board): Boolean = renumbered() == other.renumbered()

    private fun change(id: Int, to: (BoardGraph) -> BoardGraph) = copy(graphs = graphs.map { if (it.id == id) to(it) else it })
}

/**
 * The content of one graph, by names only, so that the same graph fits every recording of a robot.
 *
 * @property id identifies the graph on its board, and has no other meaning. It is written only where several tabs or windows remember a
 *   board.
 * @property title the heading above the graph.
 * @property lines the names of the drawn signals, each once; names that a recording lacks are not drawn.
 * @property isFilled whether the area below the lines is filled.
 * @property includesZero whether y must include 0.
 * @property yRange the part of y that a person selected, finite and wider than 0, on the left axis if there are two; null to fit the
 *   visible samples.
 * @property height the height in density-independent pixels, within [HEIGHTS]; null for the default. See [GraphHeight].
 * @property rightYRange the same as [yRange] for the right axis.
 * @property sharesY whether all graphs that share y show the same part of it for each unit; a fixed range is not shared.
 * @property hidden the [lines] that are currently not drawn.
 * @property isXy whether the lines are drawn without the common x: poses as paths on a field, other lines over the first one.
 * @property xRange the part of x that a person selected in such a graph, with [yRange] for y; null for all of it.
 * @property origin the origin of the poses in such a graph.
 */
data class BoardGraph(
    val id: Int,
    val title: String,
    val lines: List<String>,
    val isFilled: Boolean = false,
    val includesZero: Boolean = false,
    val yRange: Span? = null,
    val height: Int? = null,
    val rightYRange: Span? = null,
    val sharesY: Boolean = false,
    val hidden: Set<String> = emptySet(),
    val isXy: Boolean = false,
    val xRange: Span? = null,
    val origin: FieldOrigin = FieldOrigin.BLUE,
) {
    /** The part of the plane that a person selected in a graph of y over x. Null for the whole plane. */
    val plane: Plane? get() = if (isXy && xRange != null && yRange != null) Plane(xRange, yRange) else null

    /** Whether a person selected a part of y on one of the axes. */
    val isYFixed: Boolean get() = yRange != null || rightYRange != null

    internal fun drawsAs(other: BoardGraph) = lines == other.lines && isXy == other.isXy

    companion object {
        /** The possible heights of a graph of numbers, in density-independent pixels. */
        val HEIGHTS: IntRange = 60..600
    }
}

/** The exception for a text that is not a board; the message is a sentence with the reason. */
class BoardException(message: String) : IllegalArgumentException(message)

/** Returns whether this graph draws one line over another, rather than the paths of [poses]. */
fun BoardGraph.canSwapAxes(poses: List<Pose>): Boolean = isXy && lines.size == 2 && poses.none { it.x in lines && it.y in lines }
