package badlog.viewer.choices.board

import badlog.core.analysis.Span
import badlog.core.json.JsonReader
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
