package badlog.viewer.graph

import badlog.analysis.Units
import badlog.viewer.graph.plot.DrawnLine
import badlog.viewer.graph.plot.PlotPicture
import badlog.viewer.graph.text.numberText
import badlog.viewer.graph.text.withUnit

/**
 * The sample of [line] nearest to the [cursor], or the last one so far where values hold, as a person reads it, exactly as it was
 * logged; empty without a cursor, and while [picture] does not have the line yet.
 */
internal fun readingOf(picture: PlotPicture?, line: DrawnLine, cursor: Double?): String {
    if (picture == null || cursor == null) return ""
    if (picture.lines.any { it.line == line }) return withUnit(numberText(line.valueAt(cursor)), line.signal.unit)
    val lane = picture.lanes.firstOrNull { it.line == line } ?: return ""
    val value = line.valueAt(cursor)
    return if (value.isNaN()) "–" else lane.states.getOrElse(value.toInt()) { "?" }
}

/** What the line says at [cursor] on the window's x; NaN where it says nothing. */
private fun DrawnLine.valueAt(cursor: Double): Double =
    signal.indexAt(cursor - offset).let { if (it < 0) Double.NaN else signal.series.y[it] }

/** The unit of [line] as it is shown: nothing for none. */
internal fun unitText(line: DrawnLine): String = line.signal.unit.takeUnless { Units.isNone(it) }.orEmpty()
