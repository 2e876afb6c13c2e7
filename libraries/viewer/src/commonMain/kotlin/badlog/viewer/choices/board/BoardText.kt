package badlog.viewer.choices.board

import badlog.core.analysis.Span
import badlog.viewer.text.addressText
import badlog.viewer.text.nameOfAddress

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

/**
 * Returns the texts of [lines] in an address, in their order. Consecutive elements of an array are one text with a range between colons:
 * `Modules[0]/speed` to `Modules[3]/speed` are `Modules:0-3:/speed`, and `Currents[2]` alone is `Currents:2:`.
 */
internal fun lineTexts(lines: List<String>): List<String> {
    val runs = ArrayList<ElementRun>()
    for (line in lines) {
        val element = elementOf(line)
        val before = runs.lastOrNull()
        if (element != null && before?.isFollowedBy(element) == true) {
            runs[runs.size - 1] = before.copy(last = element.first)
        } else {
            runs += element ?: ElementRun(line)
        }
    }
    return runs.map { it.toText() }
}

/**
 * Returns the names of the lines for which [lineTexts] wrote [text].
 *
 * @throws BoardException if the text is neither a name nor a possible range of an array.
 */
internal fun linesOfText(text: String): List<String> {
    if (text == NAMELESS) return listOf("")
    val parts = text.split(RANGE)
    if (parts.size != PARTS) return listOf(nameOf(text))
    val first = parts[1].substringBefore('-').toIntOrNull()
    val last = parts[1].substringAfter('-').toIntOrNull()
    if (first == null || last == null || first < 0 || last < first || last - first >= MAX_ELEMENTS) {
        throw BoardException("“${parts[1]}” is not a range of elements; copy the whole address again.")
    }
    val (before, after) = nameOf(parts[0]) to nameOf(parts[2])
    return (first..last).map { "$before[$it]$after" }
}

/**
 * Returns the name that [addressText] wrote as [text].
 *
 * @throws BoardException if it is damaged.
 */
internal fun nameOf(text: String): String =
    nameOfAddress(text) ?: throw BoardException("“$text” has a “~” that is not a character; copy the whole address again.")

/** The elements [first] to [last] of an array. Their names have [before], the index and [after]; without an index, just a name. */
private data class ElementRun(val before: String, val first: Int = NO_INDEX, val last: Int = first, val after: String = "") {
    fun isFollowedBy(next: ElementRun) = first != NO_INDEX && next.before == before && next.after == after && next.first == last + 1 &&
        next.first - first < MAX_ELEMENTS

    fun toText(): String {
        val name = addressText(before)
        if (first == NO_INDEX) return name.ifEmpty { NAMELESS }
        val range = if (first == last) "$first" else "$first-$last"
        return name + RANGE + range + RANGE + addressText(after)
    }
}

/** Returns the element that [name] describes. For `Modules[0]/speed`, the first of an array; null if it is not an element. */
private fun elementOf(name: String): ElementRun? {
    val open = name.lastIndexOf('[')
    val close = name.indexOf(']', open + 1)
    if (open < 0 || close < 0) return null
    val digits = name.substring(open + 1, close)
    // Only an index as it is written: neither 07 nor +7.
    val index = digits.toIntOrNull()?.takeIf { it >= 0 && "$it" == digits } ?: return null
    return ElementRun(name.substring(0, open), index, after = name.substring(close + 1))
}

private const val NO_INDEX = -1
private const val NAMELESS = "~"

// A character that names in an address never have.
private const val RANGE = ':'
private const val PARTS = 3

/** The maximum number of elements, more than arrays have; it limits the effect of a damaged address. */
private const val MAX_ELEMENTS = 1_000
