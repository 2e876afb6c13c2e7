package badlog.viewer.shown.cursor

import badlog.core.analysis.GraphSeries
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit

/**
 * Returns the announcement of a screen reader when a key has moved a cursor to [x]. It has [place], the text of x, and the first values of
 * [lines] there.
 */
fun spokenAt(lines: List<GraphSeries>, x: Double, place: String): String {
    val values = lines.take(MAX_SPOKEN).mapNotNull { line ->
        val text = line.textOf(line.indexAt(x)) { withUnit(numberText(it), line.unit) }
        if (text.isEmpty()) null else "${line.name} $text"
    }
    return (listOf(place) + values).joinToString(", ")
}

private const val MAX_SPOKEN = 4
