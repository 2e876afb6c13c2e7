package badlog.viewer.choices.board

/**
 * A board as one recording can show it.
 *
 * @property board the graphs with at least one line in the recording.
 * @property missing the lines that the recording lacks, each once.
 * @property dropped the titles of the graphs without any line in the recording.
 */
class FittedBoard(val board: Board, val missing: List<String>, val dropped: List<String>) {
    /** A sentence about the hidden graphs and lines; null if nothing is hidden. */
    val sentence: String?
        get() {
            if (missing.isEmpty()) return null
            val names = missing.take(MAX_NAMES).joinToString { "“${it.take(MAX_NAME_LENGTH)}”" }
            val more = if (missing.size > MAX_NAMES) " and ${missing.size - MAX_NAMES} more" else ""
            return when (dropped.size) {
                0 -> "Topics not in this log: $names$more."
                1 -> "1 graph hidden: topics not in this log ($names$more)."
                else -> "${dropped.size} graphs hidden: topics not in this log ($names$more)."
            }
        }
}

/**
 * Returns the part of this board that a recording can show. [isThere] says whether it has a line; a graph without any known line is
 * dropped.
 *
 * @param excused names that do not count as missing, such as names of formulas, because their problems are reported elsewhere.
 */
fun Board.fittedTo(excused: Set<String> = emptySet(), isThere: (String) -> Boolean): FittedBoard {
    val missing = LinkedHashSet<String>()
    val dropped = ArrayList<String>()
    val fitting = graphs.mapNotNull { graph ->
        val (known, unknown) = graph.lines.partition(isThere)
        missing += unknown - excused
        if (known.isEmpty()) dropped += graph.title
        graph.copy(lines = known, hidden = graph.hidden - unknown.toSet()).takeIf { known.isNotEmpty() }
    }
    return FittedBoard(Board(fitting), missing.toList(), dropped)
}

/**
 * Returns this board, with the graphs of [start] below it if a recording has none of this board's lines. [isThere] says whether it has a
 * line.
 */
fun Board.withFallback(start: () -> Board, isThere: (String) -> Boolean): Board =
    if (graphs.any { it.lines.any(isThere) }) this else Board(graphs + start().graphs)

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

private const val MAX_NAMES = 3
private const val MAX_NAME_LENGTH = 60
