package badlog.viewer.draw.figure

import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.text.countText

/**
 * Draws a self-explanatory figure. At the top is the [title], usually the log's name, with the visible range and the cursor. The [parts]
 * follow, which draw themselves one below the other. At the bottom are the findings in the range.
 */
fun Sheet.figure(title: String, notes: FigureNotes, parts: List<(Sheet) -> Unit>) {
    line(HEADING)
    text(title, TITLE, PenColors.LIGHT[Shade.TEXT], isBold = true)
    line(LINE)
    text(notes.place, LETTERS)
    for (part in parts) part(this)
    space(GAP)
    for (finding in notes.findings) {
        line(LINE)
        text(finding.head, LETTERS, PenColors.LIGHT.severity(finding.severity), isBold = true)
        text(finding.text, LETTERS)
    }
    if (notes.moreFindings == 0) return
    line(LINE)
    text("${countText(notes.moreFindings, "more finding")} in this range", LETTERS)
}

/**
 * An entry of a figure's legend.
 *
 * @property text the name of the line, and its value at the cursor.
 * @property color the index of the line's color; null if it has none.
 */
class LegendEntry(val text: String, val color: Int?)

/** Writes the title of a graph with its [unit], and its [legend]. */
fun Sheet.graphHead(title: String, unit: String, legend: List<LegendEntry>) {
    line(GRAPH_HEADING)
    text(if (unit.isEmpty()) title else "$title ($unit)", GRAPH_TITLE, PenColors.LIGHT[Shade.TEXT], isBold = true)
    if (legend.isNotEmpty()) line(LINE)
    for (entry in legend) {
        if (!hasRoomFor(entry.text, LETTERS)) line(LINE)
        entry.color?.let { swatch(PenColors.LIGHT.line(it)) }
        text(entry.text, LETTERS)
    }
    space(GAP)
}

/** Writes the title of the x axis below a graph. */
fun Sheet.xTitle(title: String) {
    space(GAP)
    textAtRight(title, LETTERS)
}

private const val HEADING = 26.0
private const val TITLE = 15.0
private const val LINE = 18.0
private const val LETTERS = 12.0
private const val GAP = 6.0
private const val GRAPH_HEADING = 24.0
private const val GRAPH_TITLE = 13.0
