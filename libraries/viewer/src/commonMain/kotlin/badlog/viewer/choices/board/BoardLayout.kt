package badlog.viewer.choices.board

import badlog.core.analysis.Span
import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.core.json.quotedJson

/**
 * The part of a layout file that page and window share. The rest of a file belongs to the window: the open recording, the compared logs,
 * the selection, and the open parts of the window. It is ignored when reading, and not written.
 *
 * @property board the graphs; null for the default ones.
 * @property visible the visible range; null for all of x.
 * @property formulas the definitions of topics that are calculated from others.
 */
class BoardLayout(val board: Board?, val visible: Span? = null, val formulas: List<String> = emptyList()) {
    /** Returns the text of the layout file. */
    fun toJson(): String = buildString {
        append(board?.toJson()?.removeSuffix("}") ?: VERSIONED)
        appendSpan("visible", visible)
        append(",\"formulas\":").append(formulas.joinToString(",", "[", "]", transform = ::quotedJson)).append("}\n")
    }

    companion object {
        /** The ending of a layout file's name. */
        const val ENDING: String = ".badlog-layout.json"

        /** The format version that this program writes; it cannot read newer ones. */
        const val VERSION: Int = 1

        /** The key that identifies a layout file; its value is the [VERSION]. */
        const val VERSION_KEY: String = "badlog-layout"
    }
}

/**
 * Returns the name that is [steps] after [current] in [kept], the ordered names of kept layouts, wrapping around. If [current] is not kept,
 * 1 leads to the first name, and -1 to the last. Null if none is kept.
 */
fun keptLayoutAfter(kept: List<String>, current: String?, steps: Int): String? {
    if (kept.isEmpty()) return null
    val at = kept.indexOf(current)
    val next = if (at < 0 && steps > 0) steps - 1 else maxOf(at, 0) + steps
    return kept[next.mod(kept.size)]
}

/** Returns the message that no layout is kept; [how] completes the sentence with the way to keep one. */
fun noLayoutKept(how: String): String = "No layout is kept yet; $how, such as “Power” or “Drive”."

/**
 * Returns the layout in [text], the content of the file called [name].
 *
 * @throws BoardException if it is not a layout, or is from a newer badlog.
 */
fun boardLayoutOf(name: String, text: String): BoardLayout {
    val members = JsonReader.readObject(text)?.associate { it.key to it.value }
    val version = members?.get(BoardLayout.VERSION_KEY)?.json?.toDoubleOrNull()
    if (members == null || version == null) {
        throw BoardException(layoutMistake(name, text))
    }
    if (version > BoardLayout.VERSION) throw BoardException("$name was saved by a newer badlog; update badlog to open it.")
    val visible = members["visible"]?.members?.associate { it.key to it.value.json.toDoubleOrNull() }
    return BoardLayout(
        board = members["graphs"]?.takeIf { it.json != "null" }?.let { boardOf(it) { place -> " (${lineAndColumn(text, place)})" } },
        visible = visible?.let { Span(it["from"] ?: Double.NaN, it["to"] ?: Double.NaN) }?.takeIf(::isWritable),
        formulas = members["formulas"]?.items.orEmpty().mapNotNull { it.text },
    )
}

/**
 * Returns the sentence that [text], the content of the file called [name], is not a layout. It has the place where the text stops being
 * JSON.
 */
fun layoutMistake(name: String, text: String): String {
    val place = JsonReader.mistakeIn(text)?.let { " in ${lineAndColumn(text, it)}" }.orEmpty()
    return "$name is not a layout, or is damaged$place; select a file that badlog has saved."
}

/** Returns the line and column of [place], an index in [text]: `line 3, column 14`. */
private fun lineAndColumn(text: String, place: Int): String {
    val before = text.take(place)
    return "line ${before.count { it == '\n' } + 1}, column ${place - before.lastIndexOf('\n')}"
}

/**
 * Returns the board as a JSON object with a version and the key `graphs`, as in layout files. Each graph has a `title` and the names of
 * its `lines`, and, if set, `filled`, `zero`, `y` and `right` with `from` and `to`, `shared`, `height`, and the names of `hidden` lines.
 * It has `xy` if the lines are not drawn over the common x, with the visible range `x` and the `origin` of poses: `red`, `auto` or
 * `center`. An older badlog ignores unknown keys.
 *
 * @param haveIds whether each graph also has its `id`, by which tabs and windows that change the same board recognize it; without one,
 *   the id is the graph's place from 1 on.
 */
fun Board.toJson(haveIds: Boolean = false): String = graphs.indices.joinToString(",", "$VERSIONED,\"graphs\":[", "]}") { i ->
    val graph = graphs[i]
    buildString {
        append('{')
        if (haveIds && graph.id != i + 1) append("\"id\":").append(graph.id).append(',')
        append("\"title\":").append(quotedJson(graph.title))
        append(",\"lines\":").append(graph.lines.joinToString(",", "[", "]", transform = ::quotedJson))
        if (graph.isFilled) append(",\"filled\":true")
        if (graph.includesZero) append(",\"zero\":true")
        appendSpan("y", graph.yRange)
        appendSpan("right", graph.rightYRange)
        if (graph.sharesY) append(",\"shared\":true")
        graph.height?.let { append(",\"height\":").append(it) }
        if (graph.isXy) append(",\"xy\":true")
        appendSpan("x", graph.xRange)
        if (graph.origin != FieldOrigin.BLUE) append(",\"origin\":").append(quotedJson(graph.origin.key))
        val hidden = graph.lines.filter { it in graph.hidden }
        if (hidden.isNotEmpty()) hidden.joinTo(this, ",", ",\"hidden\":[", "]", transform = ::quotedJson)
        append('}')
    }
}

/**
 * Appends the member [key] with [span] to the object that is being written. Nothing is written if the span is null, or not finite and
 * wider than 0.
 */
internal fun StringBuilder.appendSpan(key: String, span: Span?) {
    if (span == null || !isWritable(span)) return
    append(",\"").append(key).append("\":{\"from\":").append(span.from).append(",\"to\":").append(span.to).append('}')
}

/**
 * Returns the board in the JSON object [text]; [toJson] describes it. Other keys, such as the further ones of a layout file, are ignored. A
 * text without a version, as older pages stored it, has version 1.
 *
 * @throws BoardException if the text has no board, the board is damaged, or its version is from a newer badlog.
 */
fun boardOfJson(text: String): Board {
    val members = JsonReader.readObject(text) ?: throw BoardException("This is not a JSON object; select a file that badlog has saved.")
    val version = members.findLast { it.key == BoardLayout.VERSION_KEY }?.value?.json?.toDoubleOrNull() ?: 1.0
    if (version > BoardLayout.VERSION) throw BoardException("The graphs were saved by a newer badlog; update badlog to open them.")
    return boardOf(members.findLast { it.key == "graphs" }?.value) { "" }
}

/**
 * Returns the board with the graphs in the JSON list [graphs].
 *
 * @param placeText returns the text for the place of a mistake, with a leading space, from its index in the JSON.
 */
internal fun boardOf(graphs: JsonValue?, placeText: (Int) -> String): Board = try {
    val items = graphs?.items ?: throw Damage("“graphs” is not a list", graphs)
    val read = items.mapIndexed { i, graph -> graphOf(i + 1, graph) }
    val ids = items.mapIndexed { i, graph -> graph["id"]?.json?.toIntOrNull() ?: (i + 1) }
    // A file that a person has put together may have an id twice.
    Board(if (ids.distinct().size == ids.size) read.mapIndexed { i, graph -> graph.copy(id = ids[i]) } else read)
} catch (e: Damage) {
    val place = e.place?.let(placeText).orEmpty()
    throw BoardException("The graphs are damaged: ${e.what}$place; select a file that badlog has saved.")
}

/** The start of each JSON object with graphs. */
internal const val VERSIONED = "{\"${BoardLayout.VERSION_KEY}\":${BoardLayout.VERSION}"

private class Damage(val what: String, place: JsonValue?) : Exception() {
    val place = place?.start
}

private fun graphOf(id: Int, graph: JsonValue): BoardGraph {
    if (graph.members == null) throw Damage("graph $id is not an object", graph)
    val lines = graph["lines"]?.items ?: throw Damage("graph $id has no list of “lines”", graph)
    val names = lines.map { it.text ?: throw Damage("a line of graph $id is not a name", it) }.distinct()
    return BoardGraph(
        id = id,
        title = graph["title"]?.text ?: throw Damage("graph $id has no “title”", graph),
        lines = names,
        isFilled = graph.isSet("filled", id),
        includesZero = graph.isSet("zero", id),
        yRange = graph.span("y", id),
        rightYRange = graph.span("right", id),
        sharesY = graph.isSet("shared", id),
        height = graph["height"]?.let { graph.number("height", id).coerceIn(HEIGHTS).toInt() },
        hidden = graph["hidden"]?.items.orEmpty().mapNotNullTo(HashSet()) { item -> item.text?.takeIf { it in names } },
        isXy = graph.isSet("xy", id),
        xRange = graph.span("x", id),
        origin = FieldOrigin.of(graph["origin"]?.text) ?: FieldOrigin.BLUE,
    )
}

/** Returns the member [key]; null if there is none, or if it is null. */
private operator fun JsonValue.get(key: String): JsonValue? = members?.findLast { it.key == key }?.value?.takeIf { it.json != "null" }

private fun JsonValue.isSet(key: String, graph: Int): Boolean = when (get(key)?.json ?: "false") {
    "true" -> true
    "false" -> false
    else -> throw Damage("“$key” of graph $graph is neither true nor false", get(key))
}

private fun JsonValue.number(key: String, graph: Int): Double {
    val value = get(key)
    // The first character distinguishes a number from a text, which has quotes.
    return value?.json?.takeIf { it[0] == '-' || it[0] in '0'..'9' }?.toDoubleOrNull()
        ?: throw Damage("“$key” of graph $graph is not a number", value ?: this)
}

private fun JsonValue.span(key: String, graph: Int): Span? =
    get(key)?.let { Span(it.number("from", graph), it.number("to", graph)).takeIf(::isWritable) }

private val HEIGHTS = BoardGraph.HEIGHTS.first.toDouble()..BoardGraph.HEIGHTS.last.toDouble()
