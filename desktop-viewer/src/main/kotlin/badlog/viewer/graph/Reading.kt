package badlog.viewer.graph

import badlog.analysis.Series
import badlog.analysis.Units
import badlog.viewer.graph.plot.DrawnLine
import badlog.viewer.graph.plot.PlotPicture
import badlog.viewer.graph.text.numberText
import badlog.viewer.graph.text.withUnit

/**
 * The sample of [line] nearest to the [cursor] as a person reads it, exactly as it was logged; empty without a cursor, and while
 * [picture] does not have the line yet.
 */
internal fun readingOf(picture: PlotPicture?, line: DrawnLine, cursor: Double?): String {
    if (picture == null || cursor == null) return ""
    picture.lines.firstOrNull { it.line == line }?.let { return withUnit(numberText(it.series.valueAt(cursor - line.offset)), line.signal.unit) }
    val lane = picture.lanes.firstOrNull { it.line == line } ?: return ""
    val value = lane.series.valueAt(cursor - line.offset)
    return if (value.isNaN()) "–" else lane.states.getOrElse(value.toInt()) { "?" }
}

/** The value of the sample nearest to [x]; NaN without samples. */
internal fun Series.valueAt(x: Double): Double = nearest(x).let { if (it < 0) Double.NaN else y[it] }

/** The unit of [line] as it is shown: nothing for none. */
internal fun unitText(line: DrawnLine): String = line.signal.unit.takeUnless { Units.isNone(it) }.orEmpty()
