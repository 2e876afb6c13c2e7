package badlog.viewer.choices.board

import badlog.core.analysis.Span
import badlog.viewer.text.addressText

/**
 * Returns the board as the shortest text that is valid in any address: only letters, digits and `-_./:;,=+~`. Graphs are separated by
 * `;`, the lines of a graph by `,`. The title, unless it is the first line's name, and the other settings follow, each after a `,` and a
 * letter with `=`: `Arm/Angle,Arm/Goal,t=Arm,f=,y=0:90,x=1;Mode`, which hides line 1, counted from 0. `p=` makes a plot of y over x, with
 * `w=` for the visible x, and `o=red`, `o=auto` or `o=center` for the origin of poses. Lines are written by [lineTexts], a title by
 * [addressText]; a line without a name is just `~`.
 */
fun Board.toText(): String = graphs.joinToString(";") { graph ->
    buildString {
        lineTexts(graph.lines).joinTo(this, ",")
        if (graph.title != graph.lines.firstOrNull()) {
            append(",t=").append(addressText(graph.title))
        }
        if (graph.isFilled) append(",f=")
        if (graph.includesZero) append(",z=")
        graph.yRange?.takeIf(::isWritable)?.let { append(",y=").append(spanText(it)) }
        graph.rightYRange?.takeIf(::isWritable)?.let { append(",r=").append(spanText(it)) }
        if (graph.sharesY) append(",s=")
        graph.height?.let { append(",h=").append(it) }
        if (graph.isXy) append(",p=")
        graph.xRange?.takeIf(::isWritable)?.let { append(",w=").append(spanText(it)) }
        if (graph.origin != FieldOrigin.BLUE) append(",o=").append(graph.origin.key)
        val hidden = graph.lines.indices.filter { graph.lines[it] in graph.hidden }
        if (hidden.isNotEmpty()) hidden.joinTo(this, ":", ",x=")
    }
}

/**
 * Returns the board in [text]; [toText] describes it.
 *
 * @throws BoardException if the text is not a board.
 */
fun boardOfText(text: String): Board {
    if (text.isEmpty()) return Board()
    return Board(text.split(';').mapIndexed { i, part -> graphOf(i + 1, part) })
}

/** The maximum number of lines in a graph, more than are ever drawn. A damaged address must not fill the memory. */
private const val MAX_LINES = 10_000

private fun graphOf(id: Int, text: String): BoardGraph {
    var graph = BoardGraph(id, "", emptyList())
    val lines = LinkedHashSet<String>()
    var title: String? = null
    var hidden = emptySet<Int>()
    val parts = if (text.isEmpty()) emptyList() else text.split(',')
    for (part in parts) {
        if (part.length >= 2 && part[1] == '=') {
            val value = part.substring(2)
            when (part[0]) {
                't' -> title = nameOf(value)
                'f' -> graph = graph.copy(isFilled = true)
                'z' -> graph = graph.copy(includesZero = true)
                'y' -> graph = graph.copy(yRange = spanOf(value))
                'r' -> graph = graph.copy(rightYRange = spanOf(value))
                's' -> graph = graph.copy(sharesY = true)
                'x' -> hidden = value.split(':').mapNotNullTo(HashSet()) { it.toIntOrNull() }
                'p' -> graph = graph.copy(isXy = true)
                'w' -> graph = graph.copy(xRange = spanOf(value))
                'o' -> graph = graph.copy(origin = originOf(value))
                'h' -> graph = graph.copy(height = heightOf(value))
                else -> throw BoardException("Graph $id has “${part[0]}”, which is unknown here; update badlog to open this.")
            }
        } else if (part.isNotEmpty()) {
            lines += linesOfText(part)
            if (lines.size > MAX_LINES) throw BoardException("Graph $id has more lines than can be drawn; copy the whole address again.")
        }
    }
    return graph.copy(
        title = title ?: lines.firstOrNull().orEmpty(),
        lines = lines.toList(),
        hidden = lines.filterIndexedTo(HashSet()) { i, _ -> i in hidden },
    )
}

/** Returns [span] as `0.5:90`, which [spanOf] reads. */
internal fun spanText(span: Span): String = "${numberOf(span.from)}:${numberOf(span.to)}"

private fun numberOf(value: Double) = value.toString().replace("+", "")

/** Returns the span in [text]; null if it is not a span that can be shown. */
internal fun spanOfText(text: String): Span? {
    val from = text.substringBefore(':').toDoubleOrNull() ?: return null
    val to = text.substringAfter(':', "").toDoubleOrNull() ?: return null
    return Span(from, to).takeIf(::isWritable)
}

private fun spanOf(text: String): Span = spanOfText(text) ?: throw BoardException("“$text” is not a range; copy the whole address again.")

private fun originOf(text: String): FieldOrigin =
    FieldOrigin.of(text) ?: throw BoardException("“$text” is not an origin of poses; copy the whole address again.")

private fun heightOf(text: String): Int =
    text.toIntOrNull()?.coerceIn(BoardGraph.HEIGHTS) ?: throw BoardException("“$text” is not a height; copy the whole address again.")

/** Returns whether [range] can be written: it is not empty, and finite, because JSON has only finite numbers. */
internal fun isWritable(range: Span): Boolean = range.from < range.to && range.from.isFinite() && range.to.isFinite()
