package badlog.viewer.panel

import badlog.core.analysis.GraphSeries
import badlog.viewer.shown.cursor.CursorValues
import badlog.viewer.shown.cursor.indexAt
import badlog.viewer.shown.cursor.textOf
import badlog.viewer.text.countText
import badlog.viewer.text.exactText
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit

/** The displayed [name] of [line], and the button that draws it; null for a line that no graph can have. */
class CursorLine(val name: String, val line: GraphSeries, val pin: Button?)

/**
 * Returns the values of [lines] at the cursor, those that have just changed first.
 *
 * @param values the order of the lines at the cursor.
 * @param x the place of the cursor; null for none.
 * @param place the text of [x].
 */
fun cursorPanel(lines: List<CursorLine>, values: CursorValues, x: Double?, place: String): List<Part> {
    val rows = values.at(x ?: Double.NaN).take(MAX_ROWS).mapIndexed { i, found ->
        val row = lines[found.line]
        fun text(format: (Double) -> String) =
            if (x == null) "" else row.line.textOf(row.line.indexAt(x)) { withUnit(format(it), row.line.unit) }
        // The key is the position, because changing the text of a row costs less than moving it.
        Value("cursor-value $i", row.name, text(::numberText), found.hasChanged, listOfNotNull(row.pin)) { text(::exactText) }
    }
    val more = lines.size - MAX_ROWS
    val hint = listOfNotNull(
        "No topic matches.".takeIf { lines.isEmpty() },
        "Point at a graph, or click it.".takeIf { lines.isNotEmpty() && x == null },
        "And ${countText(more)} more: search to find them.".takeIf { more > 0 },
    ).joinToString(" ")
    return listOfNotNull(
        Paragraph("cursor-place", place, Tone.MUTED).takeIf { x != null },
        Paragraph("hint", hint, Tone.MUTED).takeIf { hint.isNotEmpty() },
        Rows("cursor-values", "Values", rows, isLong = true),
    )
}

/** The maximum number of rows; more cannot be read while the cursor moves. */
private const val MAX_ROWS = 200
