package badlog.plot.board

import badlog.analysis.Span
import badlog.json.JsonReader
import badlog.json.quotedJson

/**
 * The part of a layout file that page and window both know. What else a file has (the open recording, what it was compared with, what was
 * selected, which parts of the window were open) is the window's: it is passed over in reading, and not written.
 *
 * @property board the graphs; null for those that a log begins with.
 * @property visible the part of x that was seen; null for all.
 * @property formulas the definitions of topics that are calculated from others.
 */
public class BoardLayout(public val board: Board?, public val visible: Span? = null, public val formulas: List<String> = emptyList()) {
    /** The layout as the file has it. */
    public fun toJson(): String = buildString {
        append("{\"").append(VERSION_KEY).append("\":").append(VERSION)
        board?.let { append(',').append(it.toJson().removePrefix("{").removeSuffix("}")) }
        appendSpan("visible", visible)
        append(",\"formulas\":").append(formulas.joinToString(",", "[", "]", transform = ::quotedJson)).append("}\n")
    }

    public companion object {
        /** How the names of layout files end. */
        public const val ENDING: String = ".badlog-layout.json"

        /** The format that this program writes; it reads no newer one. */
        public const val VERSION: Int = 1

        /** What a layout file is known by; it has the [VERSION]. */
        public const val VERSION_KEY: String = "badlog-layout"
    }
}

/**
 * The layout that the file called [name] has, which says [text].
 *
 * @throws BoardException when it is none, or of a newer badlog.
 */
public fun boardLayoutOf(name: String, text: String): BoardLayout {
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

/** Why [text], what the file called [name] says, is not a layout, as a sentence; with the place where it ceases to be JSON. */
public fun layoutMistake(name: String, text: String): String {
    val place = JsonReader.mistakeIn(text)?.let { " in ${lineAndColumn(text, it)}" }.orEmpty()
    return "$name is not a layout, or is damaged$place; select a file that badlog has saved."
}

/** Where [place], an index of [text], is: `line 3, column 14`. */
private fun lineAndColumn(text: String, place: Int): String {
    val before = text.take(place)
    return "line ${before.count { it == '\n' } + 1}, column ${place - before.lastIndexOf('\n')}"
}
